#include "grader/mistakes/battery.h"

#include "grader/tasks/hit_bvh/inputs.h"
#include "grader/tasks/hit_bvh/looks.h"
#include "grader/tasks/hit_bvh/queries.h"
#include "pt/tasks/hit_bvh.h"

#include <cmath>
#include <utility>

namespace grader::mistakes {
namespace {

using namespace check;

using namespace hit_bvh_inputs;

// Returns how many of the primitives were tested: 0 for up to half of them, 1 for more, 2 for all.
double share(std::size_t tested, double all) {
  const double part = static_cast<double>(tested) / all;
  return part > 0.99 ? 2 : part > 0.5 ? 1 : 0;
}

void ask(Battery& battery, const Case& c, bool with_cost) {
  battery.ask([&] { return look(c, with_cost); });
  battery.ask([&] { return look_for_any(c, with_cost); });
}

void trees(Battery& battery, RandomNumbers& make) {
  for (const Shape shape : {Shape::balanced, Shape::random, Shape::chain}) {
    for (const int n : {2, 5, 12, 24, 40}) {
      for (const bool spheres : {false, true}) {
        ask(battery, some_case(shape, {n}, with_leaves_of(3, 0, spheres), make), true);
        ask(battery, some_case(shape, {n}, with_leaves_of(6, 0.5, spheres), make), false);
      }
    }
  }
  for (const int n : {1, 3, 6, 12}) {
    ask(battery, some_case(Shape::leaf, {n}, with_leaves_of(1, 0, true), make), false);
  }
}

void walls(Battery& battery, RandomNumbers& make) {
  constexpr int kWalls = 64;
  Case c = walls_in_a_row(kWalls);
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

// Asks whether other tasks are called: hit_box, and hit_primitive for each kind.
void others(Battery& battery, RandomNumbers& make) {
  for (const bool spheres : {false, true}) {
    const Case c = six_in_a_row(spheres, make);
    battery.ask([&]() -> Battery::Numbers {
      forget_tests();
      pt::hit_bvh(c.bvh, c.primitives, c.ray);
      const Tested& log = tested();
      return {flag(log.boxes.empty()), flag(log.triangles.empty()), flag(log.spheres.empty())};
    });
  }
}

// Asks whether anything is in the way, which primitive is nearest, and whether its t has the
// precision of a double.
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
  for (int i = 0; i < 3; ++i) {
    ask(battery, some_case(Shape::leaf, {200}, with_leaves_of(1, 0, true), make), false);
  }
  Case fast = six_in_a_row(true, make), slow = six_in_a_row(false, make);
  fast.ray.direction *= 1e6;
  slow.ray.direction *= 1e-9;
  ask(battery, fast, false);
  ask_exactly(battery, slow, 6e9);
}

// A range that ends, begins, or does both at a wall. The ray enters the box of a wall where it
// meets the wall, but the box of the last wall earlier.
void ends(Battery& battery, RandomNumbers& make) {
  for (const int walls : {1, 3}) {
    for (const auto& [end, wall] :
         {std::pair{End::last, 0}, std::pair{End::first, walls - 1}, std::pair{End::both, 0}}) {
      ask_exactly(battery, walls_and_range(2, walls, wall, end, 1, make), 4 + wall);
    }
  }
  ask_exactly(battery, range_that_ends_at_a_slanting_wall(make), 7);
}

// Two walls that nearly touch; their distances are parts of t. The query knows the farther wall
// first. t is not a float: the nearest float is beyond both walls, unless they are a ten-thousandth
// apart.
void touching(Battery& battery, RandomNumbers& make) {
  constexpr double kNear = 7.3;
  for (const Shape shape : {Shape::random, Shape::leaf}) {
    for (const double apart : {2e-10, 1e-8, 1e-4}) {
      ask_exactly(battery, farther_wall_first(kNear, apart, shape, make), kNear);
    }
  }
}

// More primitives and nodes than 16 bits can count. Queries that enter most of a tree are left out.
void large_numbers(Battery& battery) {
  for (const auto& in_grid : {&first_in_grid, &last_in_grid}) {
    battery.ask([&]() -> Battery::Numbers {
      if (!is_quick_in_a_grid()) return {};
      const AimedInGrid aimed = in_grid();
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
  for (const Case& c : ranges_along_a_row(make)) ask(battery, c, true);
  walls(battery, make);
  for (const int n : {40, 70}) {
    ask(battery, some_case(Shape::chain, {n}, with_leaves_of(1, 20, true), make), false);
  }
  others(battery, make);
  extremes(battery, make);
  ends(battery, make);
  touching(battery, make);
  // As many leaves wait as there are walls. A stack that is too small loses the nearest of them.
  ask_exactly(battery, pile(700, true), 5);
  large_numbers(battery);
}

}  // namespace grader::mistakes
