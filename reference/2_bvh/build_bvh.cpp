#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <vector>

namespace pt {

namespace {

int longest_axis(Vec3 extent) {
  int axis = 0;
  if (extent.y > extent[axis]) axis = 1;
  if (extent.z > extent[axis]) axis = 2;
  return axis;
}

// Moves the primitives of the left child to the front, and returns their number, which is neither 0
// nor that of all.
std::size_t partition(std::span<const Box> boxes, std::span<int> primitives, bool by_plane) {
  Box centroids;
  for (const int i : primitives) centroids.grow(boxes[i].center());
  const int axis = longest_axis(centroids.extent());
  const auto position = [&](int i) { return boxes[i].center()[axis]; };

  const auto begin = primitives.begin();
  if (by_plane) {
    const double middle = centroids.center()[axis];
    const auto split =
        std::partition(begin, primitives.end(), [&](int i) { return position(i) < middle; });
    if (split != begin && split != primitives.end()) return split - begin;
  }
  // There is no plane, or all centroids are on one side of it, because they are equal or nearly
  // equal. The median always divides them.
  const std::size_t half = primitives.size() / 2;
  std::nth_element(begin, begin + half, primitives.end(),
                   [&](int i, int j) { return position(i) < position(j); });
  return half;
}

struct Builder {
  std::span<const Box> boxes;
  int max_leaf;
  BvhBuilder tree{boxes};

  // Returns the node above the primitives.
  //
  // Planes follow the shape of a scene. But if the centroids are at 2^-i, each plane cuts off only
  // one of them. So below `planes` levels the median divides them, which keeps the tree shallow.
  int build(std::span<int> primitives, int planes) {
    if (std::ssize(primitives) <= max_leaf) return tree.leaf(primitives);
    const std::size_t middle = partition(boxes, primitives, planes > 0);
    const int left = build(primitives.first(middle), planes - 1);
    const int right = build(primitives.subspan(middle), planes - 1);
    return tree.inner(left, right);
  }
};

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  if (boxes.empty()) return {};
  std::vector<int> primitives(boxes.size());
  std::iota(primitives.begin(), primitives.end(), 0);
  Builder builder{boxes, max_leaf};
  // This is twice the depth of a balanced tree.
  const int planes = 2 * static_cast<int>(std::bit_width(boxes.size()));
  return builder.tree.finish(builder.build(primitives, planes));
}

}  // namespace pt
