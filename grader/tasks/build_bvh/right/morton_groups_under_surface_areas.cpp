// right: groups of equal high Morton bits have trees of their own, and the surface area heuristic joins
// the groups (HLBVH: Pantaleoni and Luebke 2010; Garanzha, Pantaleoni and McAllister 2011).
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pt {

namespace {

constexpr int kBits = 10, kHighBit = 3 * kBits - 12;  // a group has 12 bits in common
constexpr int kBins = 12;

std::uint32_t morton_code(Vec3 p, const Box& around) {
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = around.extent()[axis];
    const double part = size > 0 ? (p[axis] - around.min[axis]) / size : 0;
    const auto place =
        static_cast<std::uint32_t>(std::min(part * (1 << kBits), (1 << kBits) - 1.0));
    for (int bit = 0; bit < kBits; ++bit) code |= (place >> bit & 1) << (3 * bit + axis);
  }
  return code;
}

double area(const Box& box) {
  const Vec3 e = box.extent();
  return box.is_empty() ? 0 : e.x * e.y + e.y * e.z + e.z * e.x;
}

struct Group {
  Box box;
  int node = 0;
};

struct Builder {
  std::span<const Box> boxes;
  std::size_t max_leaf;
  BvhBuilder tree{boxes};
  std::vector<std::uint32_t> codes{};  // by primitive

  int split_by_bits(std::span<const int> some, int bit) {
    if (some.size() <= max_leaf) return tree.leaf(some);
    std::size_t at = some.size() / 2;
    if (bit >= 0) {
      const auto second =
          std::ranges::partition_point(some, [&](int i) { return (codes[i] >> bit & 1) == 0; });
      at = static_cast<std::size_t>(second - some.begin());
      if (at == 0 || at == some.size()) return split_by_bits(some, bit - 1);
    }
    const int left = split_by_bits(some.first(at), bit - 1);
    return tree.inner(left, split_by_bits(some.subspan(at), bit - 1));
  }

  int join(std::span<Group> groups) {
    if (groups.size() == 1) return groups[0].node;
    Box centers;
    for (const Group& group : groups) centers.grow(group.box.center());
    const Vec3 size = centers.extent();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto bin_of = [&](const Group& group) {
      const double part = (group.box.center()[axis] - centers.min[axis]) / size[axis];
      return part >= 0 ? std::min(static_cast<int>(part * kBins), kBins - 1) : 0;
    };
    const int cut = cheapest_cut(groups, bin_of);
    auto second = std::partition(groups.begin(), groups.end(),
                                 [&](const Group& group) { return bin_of(group) < cut; });
    if (second == groups.begin() || second == groups.end())
      second = groups.begin() + groups.size() / 2;
    const auto at = static_cast<std::size_t>(second - groups.begin());
    const int left = join(groups.first(at));
    return tree.inner(left, join(groups.subspan(at)));
  }

  template <class BinOf>
  static int cheapest_cut(std::span<const Group> groups, const BinOf& bin_of) {
    int best = 0;
    double least = kInfinity;
    for (int cut = 1; cut < kBins; ++cut) {
      std::array<Box, 2> sides;
      std::array<int, 2> counts{};
      for (const Group& group : groups) {
        const bool right = bin_of(group) >= cut;
        sides[right].grow(group.box);
        ++counts[right];
      }
      const double cost = counts[0] * area(sides[0]) + counts[1] * area(sides[1]);
      if (cost < least) least = cost, best = cut;
    }
    return best;
  }
};

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  if (boxes.empty()) return {};
  Builder builder{boxes, static_cast<std::size_t>(max_leaf)};
  Box centroids;
  for (const Box& box : boxes) centroids.grow(box.center());
  for (const Box& box : boxes) builder.codes.push_back(morton_code(box.center(), centroids));
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) { return builder.codes[i]; });
  std::vector<Group> groups;
  for (std::span<const int> left = order; !left.empty();) {
    const std::uint32_t high = builder.codes[left[0]] >> kHighBit;
    std::size_t n = 0;
    Group group;
    for (; n < left.size() && builder.codes[left[n]] >> kHighBit == high; ++n) {
      group.box.grow(boxes[left[n]]);
    }
    group.node = builder.split_by_bits(left.first(n), kHighBit - 1);
    groups.push_back(group);
    left = left.subspan(n);
  }
  return builder.tree.finish(builder.join(groups));
}

}  // namespace pt
