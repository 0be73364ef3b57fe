#include "pt/accel/binary_tree.h"

#include "pt/accel/wide_tree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pt {

namespace {

constexpr int kBins = 16;

// Below this depth, ranges are halved: at most 32 times, even with 2^32 primitives.
constexpr int kSahDepth = kMaxTreeDepth - 32;
constexpr float kHuge = 0x1p100f;

struct Bin {
  FloatBox box;
  std::uint32_t count = 0;

  void add(const FloatBox& other, std::uint32_t n) {
    box.grow(other);
    count += n;
  }
};

// A cut of a range of primitives: those with a bin up to `plane` on `axis` go left.
struct Cut {
  float cost = kHuge;
  int axis = -1;
  int plane = 0;
};

// Twice the centre of a box; the bins are intervals of it.
float center(const FloatBox& box, int axis) { return box.min[axis] + box.max[axis]; }

// Bins of equal width between the centres of a range.
struct Binning {
  std::array<float, 3> origin{};
  std::array<float, 3> scale{};  // 0 where all centres are the same

  explicit Binning(const FloatBox& centers) {
    for (int a = 0; a < 3; ++a) {
      const float extent = centers.max[a] - centers.min[a];
      origin[a] = centers.min[a];
      // Less than kBins, so that the last centre rounds into the last bin. If the extent is so
      // small that the quotient overflows, it counts as zero.
      const float s = 0.999f * kBins / extent;
      scale[a] = extent > 0 && s < kHuge ? s : 0;
    }
  }
  int bin(const FloatBox& box, int axis) const {
    return static_cast<int>((center(box, axis) - origin[axis]) * scale[axis]);
  }
};

class Builder {
 public:
  Builder(std::vector<BoxedPrimitive> primitives, int block)
      : block_(static_cast<std::uint32_t>(block)) {
    tree_.primitives = std::move(primitives);
    if (tree_.primitives.empty()) return;
    tree_.nodes.reserve(tree_.primitives.size());
    tree_.nodes.emplace_back();
    build(0, 0, static_cast<std::uint32_t>(tree_.primitives.size()), 0);
  }

  BinaryTree take() { return std::move(tree_); }

 private:
  // The number of blocks, full but for the last. In a range that fits one block, each primitive
  // counts: it is only split where parts of it are to be other blocks.
  float leaf_cost(std::uint32_t count) const {
    const std::uint32_t blocks = (count + unit_ - 1) / unit_;
    return static_cast<float>(blocks);
  }

  // The cheapest cut of one axis, seen from both sides: the boxes of all bins to the right of each
  // plane, then those to the left.
  Cut best_cut(const std::array<Bin, kBins>& bins, int axis) const {
    std::array<float, kBins> right_cost{};
    Bin sum;
    for (int i = kBins - 1; i > 0; --i) {
      sum.add(bins[i].box, bins[i].count);
      right_cost[i] = sum.count > 0 ? sum.box.half_area() * leaf_cost(sum.count) : kHuge;
    }
    Cut best;
    sum = {};
    for (int i = 0; i + 1 < kBins; ++i) {
      sum.add(bins[i].box, bins[i].count);
      if (sum.count == 0) continue;
      const float cost = sum.box.half_area() * leaf_cost(sum.count) + right_cost[i + 1];
      if (cost < best.cost) best = {cost, axis, i};
    }
    return best;
  }

  Cut best_cut(const Binning& binning, std::uint32_t begin, std::uint32_t end) const {
    std::array<std::array<Bin, kBins>, 3> bins;
    for (std::uint32_t i = begin; i < end; ++i) {
      const FloatBox& box = tree_.primitives[i].box;
      for (int a = 0; a < 3; ++a) bins[a][binning.bin(box, a)].add(box, 1);
    }
    Cut best;
    for (int a = 0; a < 3; ++a) {
      if (!(binning.scale[a] > 0)) continue;
      const Cut cut = best_cut(bins[a], a);
      if (cut.cost < best.cost) best = cut;
    }
    return best;
  }

  // Sorts the range so that the left part comes first, and returns where the right part begins. If
  // no plane separates the boxes, they are halved in their order.
  std::uint32_t split(const FloatBox& centers, std::uint32_t begin, std::uint32_t end, int depth) {
    const std::uint32_t middle = begin + (end - begin) / 2;
    if (depth >= kSahDepth) return middle;
    unit_ = end - begin <= block_ ? 1 : block_;
    const Binning binning(centers);
    const Cut cut = best_cut(binning, begin, end);
    if (cut.axis < 0) return middle;
    const auto first = tree_.primitives.begin();
    const auto right =
        std::partition(first + begin, first + end, [&](const BoxedPrimitive& primitive) {
          return binning.bin(primitive.box, cut.axis) <= cut.plane;
        });
    return static_cast<std::uint32_t>(right - first);
  }

  void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end, int depth) {
    FloatBox box, centers;
    for (std::uint32_t i = begin; i < end; ++i) {
      const FloatBox& b = tree_.primitives[i].box;
      box.grow(b);
      FloatBox c;
      for (int a = 0; a < 3; ++a) c.min[a] = c.max[a] = center(b, a);
      centers.grow(c);
    }
    if (node == 0) tree_.cost = TreeCost(box, tree_.primitives.size());
    const std::uint32_t count = end - begin;
    tree_.nodes[node] = {box, begin, count, 0};
    // Two blocks cost the room of one more.
    const bool is_leaf = count <= block_ && tree_.cost.of(box) <= tree_.cost.room;
    if (count == 1 || is_leaf) return;
    const std::uint32_t middle = split(centers, begin, end, depth);
    const auto child = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.resize(tree_.nodes.size() + 2);
    tree_.nodes[node].child = child;
    build(child, begin, middle, depth + 1);
    build(child + 1, middle, end, depth + 1);
  }

  std::uint32_t block_, unit_ = 1;
  BinaryTree tree_;
};

}  // namespace

BinaryTree build_binary_tree(std::vector<BoxedPrimitive> primitives, int block) {
  return Builder(std::move(primitives), block).take();
}

}  // namespace pt
