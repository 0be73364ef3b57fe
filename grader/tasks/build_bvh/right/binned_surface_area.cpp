// right: the surface area heuristic over sixteen bins
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace pt {

namespace {

struct Builder {
  std::span<const Box> boxes;
  int max_leaf;
  Bvh bvh;

  int axis_of(const Box& centroids) {
    const Vec3 size = centroids.extent();
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
  }

  int split(int first, int last) {
    Box centroids;
    for (int i = first; i < last; ++i) centroids.grow(boxes[bvh.order[i]].center());
    const int axis = axis_of(centroids);
    constexpr int kBins = 16;
    struct Bin {
      Box box;
      int count = 0;
    };
    std::array<Bin, kBins> bins;
    const double low = centroids.min[axis], size = centroids.extent()[axis];
    if (!(size > 0)) return (first + last) / 2;
    const auto bin_of = [&](int i) {
      return std::min(kBins - 1,
                      static_cast<int>(kBins * ((boxes[i].center()[axis] - low) / size)));
    };
    for (int i = first; i < last; ++i) {
      Bin& bin = bins[bin_of(bvh.order[i])];
      bin.box.grow(boxes[bvh.order[i]]);
      ++bin.count;
    }
    const auto cost = [](const Bin& side) {
      const Vec3 e = side.box.extent();
      return side.count * (e.x * e.y + e.y * e.z + e.z * e.x);
    };
    int best = 1;
    double least = kInfinity;
    for (int cut = 1; cut < kBins; ++cut) {
      Bin left, right;
      for (int b = 0; b < kBins; ++b) {
        Bin& side = b < cut ? left : right;
        side.box.grow(bins[b].box);
        side.count += bins[b].count;
      }
      if (left.count == 0 || right.count == 0) continue;
      if (const double c = cost(left) + cost(right); c < least) least = c, best = cut;
    }
    const auto begin = bvh.order.begin();
    const auto cut =
        std::partition(begin + first, begin + last, [&](int i) { return bin_of(i) < best; });
    return static_cast<int>(cut - begin);
  }

  int build(int first, int last) {
    const int me = static_cast<int>(bvh.nodes.size());
    bvh.nodes.push_back({});
    Box box;
    for (int i = first; i < last; ++i) box.grow(boxes[bvh.order[i]]);
    bvh.nodes[me].box = box;
    if (last - first <= max_leaf) {
      bvh.nodes[me].first = first;
      bvh.nodes[me].count = last - first;
      return me;
    }
    const int at = split(first, last);
    const int left = build(first, at);
    const int right = build(at, last);
    bvh.nodes[me].left = left;
    bvh.nodes[me].right = right;
    return me;
  }
};

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Builder builder{boxes, max_leaf, {}};
  builder.bvh.order.resize(boxes.size());
  std::iota(builder.bvh.order.begin(), builder.bvh.order.end(), 0);
  if (!boxes.empty()) builder.build(0, static_cast<int>(boxes.size()));
  return builder.bvh;
}

}  // namespace pt
