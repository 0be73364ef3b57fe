// Ordinary inputs: 2,000 lists of up to 30 boxes (clouds, long rows, grids, with flat and equal boxes among them), and leaves of any
// size; and long rows of 2,048 boxes, for the cost of a tree.
#include "pt/tasks/build_bvh.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"

#include <algorithm>

using namespace pt;
using namespace pt::inputs;

static bool holds(const Box& outer, const Box& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(outer.min[axis] <= inner.min[axis] && outer.max[axis] >= inner.max[axis])) return false;
  }
  return true;
}

static bool is_as_large(const Box& box, const Box& other) {
  return length(box.min - other.min) <= 1e-9 && length(box.max - other.max) <= 1e-9;
}

// Returns the box over the leaves below a node, or nothing if a promise is broken there. Counts the places of `order`.
static std::optional<Box> checked(const Bvh& bvh, const std::vector<Box>& boxes, int max_leaf,
                                  int node, std::vector<int>& places) {
  if (node < 0 || node >= static_cast<int>(bvh.nodes.size())) return std::nullopt;
  const BvhNode& at = bvh.nodes[static_cast<std::size_t>(node)];
  Box below;
  if (at.is_leaf()) {
    if (at.count < 1 || at.count > max_leaf || at.first < 0) return std::nullopt;
    for (int k = at.first; k < at.first + at.count; ++k) {
      if (k >= static_cast<int>(boxes.size())) return std::nullopt;
      ++places[static_cast<std::size_t>(k)];
      below.grow(boxes[static_cast<std::size_t>(bvh.order[static_cast<std::size_t>(k)])]);
    }
  } else {
    for (const int child : {at.left, at.right}) {
      if (child <= node) return std::nullopt;
      const auto part = checked(bvh, boxes, max_leaf, child, places);
      if (!part) return std::nullopt;
      below.grow(*part);
    }
  }
  if (!holds(at.box, below) || !is_as_large(at.box, below)) return std::nullopt;
  return below;
}

static bool is_right(const std::vector<Box>& boxes, int max_leaf) {
  const Bvh bvh = build_bvh(boxes, max_leaf);
  if (boxes.empty()) return bvh.nodes.empty();
  std::vector<int> order = bvh.order, places(boxes.size());
  std::sort(order.begin(), order.end());
  if (order.size() != boxes.size()) return false;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] != static_cast<int>(i)) return false;
  }
  const auto once = [](int count) { return count == 1; };
  return checked(bvh, boxes, max_leaf, 0, places) &&
         std::all_of(places.begin(), places.end(), once);
}

static std::vector<Box> any_boxes(Sampler& sampler, int kind) {
  const int count = static_cast<int>(any_number(sampler, 0, 31));
  Vec3 spread{3, 3, 3};
  spread[kind % 3] = kind % 2 == 0 ? 3 : 100;
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 v = any_vector(sampler);
    Vec3 center{v.x * spread.x, v.y * spread.y, v.z * spread.z};
    Vec3 half = Vec3{1.1, 1.1, 1.1} + any_vector(sampler);
    if (kind % 5 == 0) center = {3.0 * (i % 3), 3.0 * (i / 3 % 3), 3.0 * (i / 9)};
    if (kind % 5 == 0) half = {1, 1, 1};
    if (i % 7 == 0) half[i / 7 % 3] = 0;
    if (kind % 4 == 0 && i > 0 && i % 3 == 0) {
      boxes.push_back(boxes[0]);
      continue;
    }
    boxes.push_back({center - half, center + half});
  }
  return boxes;
}

EXAMPLE("less than 1 in 100 ordinary lists gives a wrong tree") {
  Sampler sampler(1);
  int differ = 0;
  constexpr int kInputs = 2000;
  for (int i = 0; i < kInputs; ++i) {
    if (!is_right(any_boxes(sampler, i), 1 + i % 6)) ++differ;
  }
  EXPECT(differ < kInputs / 100);
}

// The number of boxes that a ray across the axis enters: it goes along the next axis, at this place of the axis.
static int entered(const Bvh& bvh, int axis, double place) {
  const int third = (axis + 2) % 3;
  std::vector<int> waiting{0};
  int count = 0;
  while (!waiting.empty()) {
    const BvhNode& node = bvh.nodes.at(static_cast<std::size_t>(waiting.back()));
    waiting.pop_back();
    const Box& box = node.box;
    if (place < box.min[axis] || place > box.max[axis] || box.min[third] > 0 || box.max[third] < 0)
      continue;
    ++count;
    if (node.is_leaf()) continue;
    waiting.push_back(node.left);
    waiting.push_back(node.right);
  }
  return count;
}

EXAMPLE("a ray across a long row enters few boxes") {
  Sampler sampler(1);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Box> boxes;
    for (int i = 0; i < 2048; ++i) {
      Vec3 center = 0.3 * any_vector(sampler);
      center[axis] = i;
      boxes.push_back({center - Vec3{0.5, 0.5, 0.5}, center + Vec3{0.5, 0.5, 0.5}});
    }
    const Bvh bvh = build_bvh(boxes, 4);
    int sum = 0;
    for (int i = 0; i < 50; ++i) sum += entered(bvh, axis, any_number(sampler, 0, 2047));
    EXPECT(sum < 50 * 64);
  }
}
