// right: the boxes in the order of a Morton curve (1966), which the tree halves again and again.
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pt {

namespace {

std::uint64_t morton_code(Vec3 p, const Box& around) {
  constexpr int kBits = 21;
  const Vec3 e = around.extent();
  const double size = std::max({e.x, e.y, e.z});
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double part = size > 0 ? (p[axis] - around.min[axis]) / size : 0;
    const auto place = static_cast<std::uint64_t>(part * ((1 << kBits) - 1));
    for (int bit = 0; bit < kBits; ++bit) code |= (place >> bit & 1) << (3 * bit + axis);
  }
  return code;
}

int halved(std::span<const int> some, std::size_t max_leaf, BvhBuilder& tree) {
  if (some.size() <= max_leaf) return tree.leaf(some);
  const std::size_t half = some.size() / 2;
  const int left = halved(some.first(half), max_leaf, tree);
  return tree.inner(left, halved(some.subspan(half), max_leaf, tree));
}

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  if (boxes.empty()) return {};
  Box centroids;
  for (const Box& box : boxes) centroids.grow(box.center());
  std::vector<std::uint64_t> codes;
  for (const Box& box : boxes) codes.push_back(morton_code(box.center(), centroids));
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) { return codes[i]; });
  BvhBuilder tree(boxes);
  return tree.finish(halved(order, static_cast<std::size_t>(max_leaf), tree));
}

}  // namespace pt
