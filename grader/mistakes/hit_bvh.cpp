#include "pt/tasks/hit_bvh.h"

#include "grader/check/counting.h"
#include "grader/check/many.h"
#include "grader/mistakes/battery.h"
#include "grader/tasks/hit_bvh/cases.h"
#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

// The order in which a tree is walked is free. So an answer contains what was found and which rules
// on the cost were broken, but not the number of tests.

namespace grader::mistakes {
namespace {

using namespace check;

using namespace hit_bvh_cases;

using Name = std::tuple<double, double, double, double>;
Name name_of(const pt::Box& b) { return {b.min.x, b.min.y, b.max.x, b.max.z}; }
Name name_of(const pt::Triangle& t) { return {t.p0.x, t.p0.y, t.p1.x, t.p1.y}; }
Name name_of(const pt::Sphere& s) { return {s.center.x, s.center.y, s.center.z, s.radius}; }

// Returns whether something was tested more often than it occurs in the tree. Boxes may be equal.
template <class T>
bool too_often(const std::vector<T>& asked, const std::vector<T>& there) {
  std::map<Name, int> left;
  for (const T& each : there) ++left[name_of(each)];
  return std::ranges::any_of(asked, [&](const T& each) { return --left[name_of(each)] < 0; });
}

std::vector<pt::Box> boxes_of(const pt::Bvh& bvh) {
  std::vector<pt::Box> boxes;
  for (const pt::BvhNode& node : bvh.nodes) boxes.push_back(node.box);
  return boxes;
}

template <class T>
bool was_asked(const std::vector<T>& asked, const T& about) {
  return std::ranges::any_of(asked, [&](const T& one) { return name_of(one) == name_of(about); });
}

bool was_asked(const Tested& log, const pt::Primitives& primitives, int i) {
  return primitives.is_triangle(i) ? was_asked(log.triangles, primitives.triangle(i))
                                   : was_asked(log.spheres, primitives.sphere(i));
}

struct Cost {
  double box_twice = 0, primitive_twice = 0, primitive_outside = 0, box_outside = 0;
};

Cost cost_of(const Case& c, const Tested& log) {
  Cost cost;
  cost.box_twice = flag(too_often(log.boxes, boxes_of(c.bvh)));
  cost.primitive_twice = flag(too_often(log.triangles, c.primitives.triangles) ||
                              too_often(log.spheres, c.primitives.spheres));
  for (const pt::BvhNode& node : c.bvh.nodes) {
    if (c.bvh.nodes.size() == 1 || pt::hit_box(node.box, c.ray)) continue;
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (was_asked(log, c.primitives, c.bvh.order[i])) cost.primitive_outside = 1;
    }
    if (node.is_leaf()) continue;
    for (const int child : {node.left, node.right}) {
      const pt::Box& box = c.bvh.nodes[child].box;
      if (name_of(box) == name_of(node.box)) continue;  // both look the same in the log
      if (was_asked(log.boxes, box)) cost.box_outside = 1;
    }
  }
  return cost;
}

// Returns how many of the primitives were tested: 0 for up to half of them, 1 for more, 2 for all.
double share(std::size_t tested, double all) {
  const double part = static_cast<double>(tested) / all;
  return part > 0.99 ? 2 : part > 0.5 ? 1 : 0;
}

// Each query starts with an empty record, so that it contains no test of the query before.
Battery::Numbers look(const Case& c, bool with_cost) {
  forget_tests();
  const auto hit = pt::hit_bvh(c.bvh, c.primitives, c.ray);
  const Tested log = tested();
  Battery::Numbers all{flag(hit.has_value())};
  if (hit) all.insert(all.end(), {hit->t, hit->n.x, hit->n.y, hit->n.z, 1.0 * hit->primitive});
  if (!with_cost) return all;
  const Cost cost = cost_of(c, log);
  all.insert(all.end(),
             {cost.box_twice, cost.primitive_twice, cost.primitive_outside, cost.box_outside});
  return all;
}

Battery::Numbers look_for_any(const Case& c, bool with_cost) {
  forget_tests();
  const bool occluded = pt::occluded_bvh(c.bvh, c.primitives, c.ray);
  const Tested log = tested();
  Battery::Numbers all{flag(occluded)};
  if (!with_cost) return all;
  const Cost cost = cost_of(c, log);
  bool stopped = true;
  for (std::size_t i = 0; i + 1 < log.triangles.size(); ++i) {
    stopped = stopped && !pt::hit_triangle(log.triangles[i], c.ray);
  }
  all.insert(all.end(), {cost.box_twice, cost.primitive_twice, cost.primitive_outside,
                         cost.box_outside, flag(stopped)});
  return all;
}

// A ray towards the middle of a primitive or close past it. It starts outside the primitives or
// between them.
pt::Ray some_ray(const pt::Primitives& primitives, Many& make) {
  const pt::Box box = bounds(primitives, make.whole(0, primitives.size() - 1));
  const pt::Vec3 origin = make.vector(-9, 9);
  return {origin, box.center() + make.vector(-0.3, 0.3) - origin};
}

Case some_case(Many& make, Shape shape, int n, double padding, int max_leaf, bool spheres) {
  Case c;
  for (int i = 0; i < n; ++i) {
    if (spheres && make.whole(0, 2) == 0) {
      c.primitives.spheres.push_back({make.vector(-5, 5), make.between(0.1, 1.5)});
    } else {
      c.primitives.triangles.push_back(some_triangle(3, make));
    }
  }
  c.bvh = tree_of(c.primitives, shape, max_leaf, padding, make);
  c.ray = some_ray(c.primitives, make);
  return c;
}

void ask(Battery& battery, const Case& c, bool with_cost) {
  battery.ask([&] { return look(c, with_cost); });
  battery.ask([&] { return look_for_any(c, with_cost); });
}

void trees(Battery& battery, Many& make) {
  for (const Shape shape : {Shape::balanced, Shape::random, Shape::chain}) {
    for (const int n : {2, 5, 12, 24, 40}) {
      for (const bool spheres : {false, true}) {
        ask(battery, some_case(make, shape, n, 0, 3, spheres), true);
        ask(battery, some_case(make, shape, n, 0.5, 6, spheres), false);
      }
    }
  }
  for (const int n : {1, 3, 6, 12})
    ask(battery, some_case(make, Shape::leaf, n, 0, 1, true), false);
}

// Many hits along one ray, with every kind of range.
void ranges(Battery& battery, Many& make) {
  Case c = some_case(make, Shape::random, 30, 0.5, 2, true);
  for (int i = 0; i < 6; ++i) c.primitives.spheres.push_back({{0, 0, 4.0 * i}, 1});
  c.bvh = tree_of(c.primitives, Shape::random, 2, 0.1, make);
  c.ray = {{0.1, 0.2, -6}, {0, 0, 2}};
  for (const double low : {0.0, 2.7, 3.3, 4.8, 12.5, 20.0}) {
    for (const double longer : {0.4, 1.9, pt::kInfinity}) {
      c.ray.t_min = low;
      c.ray.t_max = low + longer;
      ask(battery, c, true);
    }
  }
}

void walls(Battery& battery, Many& make) {
  constexpr int kWalls = 64;
  Case c;
  for (int i = 0; i < kWalls; ++i) {
    const double z = i;
    c.primitives.triangles.push_back(pt::flat_triangle({-9, -9, z}, {9, -9, z}, {0, 18, z}));
  }
  c.ray = {{0.3, 0.2, -5}, {0.01, -0.02, 1}};
  for (int tree = 0; tree < 3; ++tree) {
    c.bvh = tree_of(c.primitives, Shape::random, 1, 0, make);
    battery.ask([&]() -> Battery::Numbers {
      forget_tests();
      const auto hit = pt::hit_bvh(c.bvh, c.primitives, c.ray);
      const auto nearest = tested().triangles.size();
      forget_tests();
      const bool any = pt::occluded_bvh(c.bvh, c.primitives, c.ray);
      return {flag(hit.has_value()), flag(any), flag(share(nearest, kWalls) == 2),
              share(tested().triangles.size(), kWalls)};
    });
  }
}

void deep(Battery& battery, Many& make) {
  for (const int n : {40, 70}) {
    Case c = some_case(make, Shape::chain, n, 20, 1, true);
    c.ray.t_min = 0;
    c.ray.t_max = pt::kInfinity;
    ask(battery, c, false);
  }
}

// Six primitives in a row. The ray meets all of them, so boxes and primitives have to be asked for.
Case row(Many& make, bool spheres) {
  Case c;
  for (int i = 0; i < 6; ++i) {
    const double z = 4.0 * i;
    if (spheres) {
      c.primitives.spheres.push_back({{0, 0, z}, 1});
    } else {
      c.primitives.triangles.push_back(pt::flat_triangle({-9, -9, z}, {9, -9, z}, {0, 18, z}));
    }
  }
  c.bvh = tree_of(c.primitives, Shape::random, 1, 0, make);
  c.ray = {{0.1, 0.2, -6}, {0.01, -0.02, 1}};
  return c;
}

// Whether others are asked: hit_box, and hit_primitive for each kind.
void others(Battery& battery, Many& make) {
  for (const bool spheres : {false, true}) {
    const Case c = row(make, spheres);
    battery.ask([&]() -> Battery::Numbers {
      forget_tests();
      pt::hit_bvh(c.bvh, c.primitives, c.ray);
      const Tested log = tested();
      return {flag(log.boxes.empty()), flag(log.triangles.empty()), flag(log.spheres.empty())};
    });
  }
}

// Leaves with many primitives, hits at a small t, and whether t is as precise as a double can be.
void extremes(Battery& battery, Many& make) {
  for (int i = 0; i < 3; ++i) ask(battery, some_case(make, Shape::leaf, 200, 0, 1, true), false);
  Case fast = row(make, true);
  fast.ray.direction = 1e6 * fast.ray.direction;
  ask(battery, fast, false);
  const Case c = row(make, false);
  battery.ask([&]() -> Battery::Numbers {
    const auto hit = pt::hit_bvh(c.bvh, c.primitives, c.ray);
    if (!hit) return {};
    return {flag(std::abs(hit->t / 6 - 1) < 1e-12)};
  });
}

}  // namespace

void run_battery(Battery& battery) {
  Many make(7);
  Case empty;
  empty.ray = {{0, 0, 0}, {0, 0, 1}};
  ask(battery, empty, false);
  trees(battery, make);
  ranges(battery, make);
  walls(battery, make);
  deep(battery, make);
  others(battery, make);
  extremes(battery, make);
}

}  // namespace grader::mistakes
