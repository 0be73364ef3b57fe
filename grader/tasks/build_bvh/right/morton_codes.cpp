// right: sorted along a Morton curve of 21 bits per axis, with one scale for all axes, and split at
// the highest bit that differs. Equal codes are halved.
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pt {
namespace {
std::uint64_t spread(std::uint64_t v) {
  std::uint64_t out = 0;
  for (int bit = 0; bit < 21; ++bit) out |= ((v >> bit) & 1u) << (3 * bit);
  return out;
}
class Morton {
 public:
  Morton(std::span<const Box> boxes, int max_leaf)
      : boxes_(boxes), max_leaf_(max_leaf), code_(boxes.size()) {
    Box c;
    for (const Box& b : boxes) c.grow(b.center());
    const Vec3 e = c.extent();
    const double size = std::max({e.x, e.y, e.z});
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Vec3 p = boxes[i].center() - c.min;
      for (int axis = 0; axis < 3; ++axis) {
        const double q = size > 0 ? p[axis] / size * 2097151.0 : 0;
        code_[i] |= spread(static_cast<std::uint64_t>(q)) << (2 - axis);
      }
    }
    out_.order.resize(boxes.size());
    std::iota(out_.order.begin(), out_.order.end(), 0);
    std::sort(out_.order.begin(), out_.order.end(),
              [&](int a, int b) { return code(a) < code(b); });
  }
  Bvh run() && {
    if (!boxes_.empty()) emit(0, static_cast<int>(boxes_.size()));
    return std::move(out_);
  }

 private:
  std::uint64_t code(int primitive) const { return code_[static_cast<std::size_t>(primitive)]; }
  std::uint64_t code_at(int i) const { return code(out_.order[static_cast<std::size_t>(i)]); }
  int emit(int begin, int end) {
    const int me = static_cast<int>(out_.nodes.size());
    out_.nodes.push_back({});
    BvhNode node;
    if (end - begin <= max_leaf_) {
      node.first = begin;
      node.count = end - begin;
      for (int i = begin; i < end; ++i)
        node.box.grow(boxes_[static_cast<std::size_t>(out_.order[static_cast<std::size_t>(i)])]);
    } else {
      int mid = (begin + end) / 2;
      if (const auto differ = code_at(begin) ^ code_at(end - 1)) {
        const std::uint64_t top = std::uint64_t{1} << (63 - std::countl_zero(differ));
        mid = begin;
        while (!(code_at(mid) & top)) ++mid;
      }
      node.left = emit(begin, mid);
      node.right = emit(mid, end);
      node.box.grow(out_.nodes[static_cast<std::size_t>(node.left)].box);
      node.box.grow(out_.nodes[static_cast<std::size_t>(node.right)].box);
    }
    out_.nodes[static_cast<std::size_t>(me)] = node;
    return me;
  }
  std::span<const Box> boxes_;
  int max_leaf_;
  std::vector<std::uint64_t> code_;
  Bvh out_;
};
}  // namespace
Bvh build_bvh(std::span<const Box> boxes, int max_leaf) { return Morton(boxes, max_leaf).run(); }
}  // namespace pt
