// right: the surface area heuristic, swept over every place of every axis
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace pt {

namespace {

double area(const Box& box) {
  const Vec3 e = box.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

class Builder {
 public:
  Builder(std::span<const Box> boxes, std::size_t max_leaf) : boxes_(boxes), max_leaf_(max_leaf) {}

  Bvh run() {
    std::vector<int> all(boxes_.size());
    std::iota(all.begin(), all.end(), 0);
    if (!all.empty()) build(all);
    return std::move(bvh_);
  }

 private:
  void sort(std::vector<int>& some, int axis) const {
    std::stable_sort(some.begin(), some.end(), [&](int a, int b) {
      return boxes_[a].center()[axis] < boxes_[b].center()[axis];
    });
  }

  // The number of triangles to the left, and the cost.
  std::pair<std::size_t, double> best_place(const std::vector<int>& some) const {
    std::vector<double> right_area(some.size());
    Box right;
    for (std::size_t i = some.size(); i-- > 0;) {
      right.grow(boxes_[some[i]]);
      right_area[i] = area(right);
    }
    Box left;
    std::size_t best = some.size() / 2;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < some.size(); ++i) {
      left.grow(boxes_[some[i - 1]]);
      const auto n = static_cast<double>(i), m = static_cast<double>(some.size() - i);
      const double cost = area(left) * n + right_area[i] * m;
      if (cost < least) {
        least = cost;
        best = i;
      }
    }
    return {best, least};
  }

  int build(std::vector<int> some) {
    const int me = static_cast<int>(bvh_.nodes.size());
    bvh_.nodes.emplace_back();
    for (const int i : some) bvh_.nodes[me].box.grow(boxes_[i]);
    if (some.size() <= max_leaf_) {
      bvh_.nodes[me].first = static_cast<int>(bvh_.order.size());
      bvh_.nodes[me].count = static_cast<int>(some.size());
      bvh_.order.insert(bvh_.order.end(), some.begin(), some.end());
      return me;
    }
    std::vector<int> best_order;
    std::size_t split = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      sort(some, axis);
      const auto [place, cost] = best_place(some);
      if (best_order.empty() || cost < least) {
        best_order = some;
        split = place;
        least = cost;
      }
    }
    const auto middle = best_order.begin() + static_cast<std::ptrdiff_t>(split);
    const int left = build({best_order.begin(), middle});
    const int right = build({middle, best_order.end()});
    bvh_.nodes[me].left = left;
    bvh_.nodes[me].right = right;
    return me;
  }

  std::span<const Box> boxes_;
  std::size_t max_leaf_;
  Bvh bvh_;
};

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  return Builder(boxes, static_cast<std::size_t>(max_leaf)).run();
}

}  // namespace pt
