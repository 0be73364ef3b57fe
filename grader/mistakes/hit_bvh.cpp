#include "pt/tasks/hit_bvh.h"

#include "grader/check/random_numbers.h"
#include "grader/mistakes/battery.h"
#include "grader/mistakes/hit_bvh_looks.h"
#include "grader/tasks/hit_bvh/ends_of_range.h"
#include "grader/tasks/hit_bvh/large_grid.h"
#include "grader/tasks/hit_bvh/scenes.h"

#include <cmath>
#include <utility>

namespace grader::mistakes {
namespace {

using namespace check;

using namespace hit_bvh_cases;

// Returns how many of the primitives were tested: 0 for up to half of them, 1 for more, 2 for all.
double share(std::size_t tested, double all) {
  const double part = static_cast<double>(tested) / all;
  return part > 0.99 ? 2 : part > 0.5 ? 1 : 0;
}

// A ray towards the middle of a primitive or close past it. It starts outside the primitives or
// between them.
pt::Ray some_ray(const pt::Primitives& primitives, RandomNumbers& make) {
  const pt::Box box = bounds(primitives, make.whole(0, primitives.size() - 1));
  const pt::Vec3 origin = make.vector(-9, 9);
  return {origin, box.center() + make.vector(-0.3, 0.3) - origin};
}

Case some_case(RandomNumbers& make, Shape shape, int n, double padding, int max_leaf,
               bool spheres) {
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

void trees(Battery& battery, RandomNumbers& make) {
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
void ranges(Battery& battery, RandomNumbers& make) {
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

void walls(Battery& battery, RandomNumbers& make) {
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

void deep(Battery& battery, RandomNumbers& make) {
  for (const int n : {40, 70}) {
    Case c = some_case(make, Shape::chain, n, 20, 1, true);
    c.ray.t_min = 0;
    c.ray.t_max = pt::kInfinity;
    ask(battery, c, false);
  }
}

// Six primitives in a row. The ray meets all of them, so boxes and primitives have to be asked for.
Case row(RandomNumbers& make, bool spheres) {
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

// Asks whether other tasks are called: hit_box, and hit_primitive for each kind.
void others(Battery& battery, RandomNumbers& make) {
  for (const bool spheres : {false, true}) {
    const Case c = row(make, spheres);
    battery.ask([&]() -> Battery::Numbers {
      forget_tests();
      pt::hit_bvh(c.bvh, c.primitives, c.ray);
      const Tested& log = tested();
      return {flag(log.boxes.empty()), flag(log.triangles.empty()), flag(log.spheres.empty())};
    });
  }
}

// Asks whether anything is in the way, which primitive is the nearest, and whether its t is as precise
// as a double can be.
void ask_exactly(Battery& battery, const Case& c, double t) {
  battery.ask([&]() -> Battery::Numbers {
    const double occluded = flag(pt::occluded_bvh(c.bvh, c.primitives, c.ray));
    const auto hit = pt::hit_bvh(c.bvh, c.primitives, c.ray);
    if (!hit) return {occluded};
    return {occluded, 1.0 * hit->primitive, flag(std::abs(hit->t / t - 1) < 1e-12)};
  });
}

// Leaves with many primitives, and hits at a small and at a large t.
void extremes(Battery& battery, RandomNumbers& make) {
  for (int i = 0; i < 3; ++i) ask(battery, some_case(make, Shape::leaf, 200, 0, 1, true), false);
  const Case spheres = row(make, true), walls = row(make, false);
  Case fast = spheres, slow = walls;
  fast.ray.direction *= 1e6;
  slow.ray.direction *= 1e-9;
  ask(battery, fast, false);
  ask_exactly(battery, slow, 6e9);
}

// A range that ends, begins, or does both at a wall. The ray enters the box of a wall where it meets
// the wall, but that of the last wall before.
void ends(Battery& battery, RandomNumbers& make) {
  for (const int walls : {1, 3}) {
    for (const auto& [end, wall] :
         {std::pair{End::last, 0}, std::pair{End::first, walls - 1}, std::pair{End::both, 0}}) {
      ask_exactly(battery, walls_and_range(2, walls, wall, end, 1, make), 4 + wall);
    }
  }
  Case slanting = flat_wall_before_a_slanting_one(9, 7, 0.3);
  slanting.bvh = tree_in_order(slanting.primitives, Shape::random, make);
  slanting.ray.t_max = hit_primitive(slanting.primitives, 1, slanting.ray)->t;
  ask_exactly(battery, slanting, 7);
}

// Two walls that all but touch, by distances that are parts of t. The query knows the farther one first.
// t is not a float: the nearest one is beyond both walls, unless they are a ten-thousandth apart.
void touching(Battery& battery, RandomNumbers& make) {
  constexpr double kNear = 7.3;
  for (const Shape shape : {Shape::random, Shape::leaf}) {
    for (const double apart : {2e-10, 1e-8, 1e-4}) {
      Case c = flat_wall_before_a_slanting_one(kNear, kNear * (1 + apart), 0.3);
      std::swap(c.primitives.triangles[0], c.primitives.triangles[1]);
      c.bvh = tree_in_order(c.primitives, shape, make);
      ask_exactly(battery, c, kNear);
    }
  }
}

// More primitives and nodes than 16 bits can count. Queries that enter most of a tree are not asked.
void large_numbers(Battery& battery) {
  for (const int place : {kFirstInGrid, kLastInGrid}) {
    battery.ask([&]() -> Battery::Numbers {
      if (!is_quick_in_a_grid()) return {};
      const AimedInGrid aimed{&large_grid(), place};
      const double occluded = flag(is_occluded(aimed));
      const auto hit = ask(aimed);
      if (!hit) return {occluded};
      return {occluded, 1.0 * hit->primitive};
    });
  }
}

}  // namespace

void run_battery(Battery& battery) {
  RandomNumbers make(7);
  Case empty;
  empty.ray = {{0, 0, 0}, {0, 0, 1}};
  ask(battery, empty, false);
  trees(battery, make);
  ranges(battery, make);
  walls(battery, make);
  deep(battery, make);
  others(battery, make);
  extremes(battery, make);
  ends(battery, make);
  touching(battery, make);
  // As many leaves wait as there are walls. A stack that is too small loses the nearest of them.
  ask_exactly(battery, pile(700, true), 5);
  large_numbers(battery);
}

}  // namespace grader::mistakes
