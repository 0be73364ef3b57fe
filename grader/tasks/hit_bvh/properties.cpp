#include "grader/property/property.h"
#include "grader/stand_ins/counting.h"
#include "grader/tasks/hit_bvh/cases.h"
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <algorithm>
#include <optional>

namespace grader {
namespace {

using namespace hit_bvh_cases;

constexpr int kCases = 150;

// What asking every primitive in turn finds.
std::optional<pt::Hit> nearest_of_all(const Case& c) {
  std::optional<pt::Hit> nearest;
  for (int i = 0; i < c.primitives.size(); ++i) {
    const auto hit = hit_primitive(c.primitives, i, c.ray);
    if (hit && !(nearest && nearest->t <= hit->t)) nearest = pt::Hit{hit->t, hit->n, i};
  }
  return nearest;
}

std::string shown(const std::optional<pt::Hit>& hit) {
  return hit ? "t " + show(hit->t) + " of primitive " + std::to_string(hit->primitive) : "no hit";
}

std::optional<pt::Hit> ask(const Case& c) { return pt::hit_bvh(c.bvh, c.primitives, c.ray); }

void expect_as_all(const Case& c) {
  const auto all = nearest_of_all(c), hit = ask(c);
  expect(hit.has_value() == all.has_value(), shown(all), shown(hit));
  if (hit) expect_near("t", hit->t, all->t, 1e-12 * all->t);
}

PROMISE(hit_bvh, finds_the_nearest_hit) {
  for_all(
      [] {
        const Case c = *some_tree();
        const auto all = nearest_of_all(c);
        if (!all) return;
        const auto hit = ask(c);
        expect(hit.has_value(), shown(all), "no hit");
        expect_near("t of the nearest hit", hit->t, all->t, 1e-12 * all->t);
      },
      2 * kCases);
}

PROMISE(hit_bvh, says_which_primitive) {
  for_all(
      [] {
        const Case c = *some_tree();
        if (!nearest_of_all(c)) return;
        const auto hit = ask(c);
        expect(hit.has_value(), "a hit", "none");
        expect(hit->primitive >= 0 && hit->primitive < c.primitives.size(), "one of the primitives",
               std::to_string(hit->primitive));
        const auto own = hit_primitive(c.primitives, hit->primitive, c.ray);
        expect(own.has_value(), "a primitive that the ray hits",
               "primitive " + std::to_string(hit->primitive) + ", which it misses");
        expect_near("t, against the t of the primitive named", hit->t, own->t, 1e-12 * own->t);
        expect_near("n, against the n of the primitive named", hit->n, own->n, 1e-12);
      },
      kCases);
}

PROMISE(hit_bvh, misses_what_is_not_there) {
  for_all(
      [] {
        const Case c = *some_tree({.most = 8});
        if (nearest_of_all(c)) return;
        const auto hit = ask(c);
        expect(!hit.has_value(), "no hit", shown(hit));
        expect(!occluded_bvh(c.bvh, c.primitives, c.ray), "nothing in the way",
               "something in the way");
      },
      2 * kCases);
}

PROMISE(hit_bvh, keeps_t_inside_the_ray) {
  for_all(
      [] {
        Case c = *some_tree();
        c.ray.t_min = 0;
        c.ray.t_max = pt::kInfinity;
        const auto first = nearest_of_all(c);
        if (!first) return;
        // Before the first hit there is none; from behind it on, the next one is the nearest.
        Case before = c, behind = c;
        before.ray.t_max = 0.999 * first->t;
        behind.ray.t_min = 1.001 * first->t;
        const auto hit = ask(before);
        expect(!hit.has_value(), "no hit with t up to " + show(before.ray.t_max), shown(hit));
        expect(!occluded_bvh(c.bvh, c.primitives, before.ray),
               "nothing in the way with t up to " + show(before.ray.t_max), "something in the way");
        expect_as_all(behind);
        expect(occluded_bvh(c.bvh, c.primitives, behind.ray) == nearest_of_all(behind).has_value(),
               "with t from " + show(behind.ray.t_min) + " on " + shown(nearest_of_all(behind)),
               "the opposite");
      },
      kCases);
}

PROMISE(hit_bvh, takes_an_empty_tree) {
  once([] {
    const auto hit = pt::hit_bvh({}, {}, {{0, 0, 0}, {0, 0, 1}});
    expect(!hit.has_value(), "no hit", shown(hit));
    expect(!pt::occluded_bvh({}, {}, {{0, 0, 0}, {0, 0, 1}}), "nothing in the way",
           "something in the way");
  });
}

PROMISE(hit_bvh, takes_a_tree_of_any_shape) {
  const auto check = [](const Case& c) {
    expect_as_all(c);
    expect(occluded_bvh(c.bvh, c.primitives, c.ray) == nearest_of_all(c).has_value(),
           "in the way: " + shown(nearest_of_all(c)), "the opposite");
  };
  for_all([=] { check(*with_tree({Shape::chain, Shape::random, Shape::balanced})); });
  for_all([=] { check(*with_tree({Shape::leaf}, {.most = 12})); });
  // Hundreds of levels, all of which the ray enters.
  for_all(
      [=] {
        Case c =
            *with_tree({Shape::chain}, {.least = 300, .most = 400, .padding = 20, .max_leaf = 1});
        c.ray.t_min = 0;
        c.ray.t_max = pt::kInfinity;
        check(c);
      },
      20);
}

PROMISE(hit_bvh, finds_any_hit) {
  for_all(
      [] {
        const Case c = *some_tree({.most = 12});
        const auto all = nearest_of_all(c);
        const bool occluded = occluded_bvh(c.bvh, c.primitives, c.ray);
        expect(occluded == all.has_value(), "in the way: " + shown(all), occluded ? "yes" : "no");
      },
      2 * kCases);
}

// What a query asked of the tasks that it calls, copied before the test asks something itself.
Tested tested_by(const Case& c, bool any) {
  forget_tests();
  if (any) {
    pt::occluded_bvh(c.bvh, c.primitives, c.ray);
  } else {
    pt::hit_bvh(c.bvh, c.primitives, c.ray);
  }
  return tested();
}

bool same(const pt::Box& a, const pt::Box& b) { return a.min == b.min && a.max == b.max; }
bool same(const pt::Sphere& a, const pt::Sphere& b) { return a.center == b.center; }
bool same(const pt::Triangle& a, const pt::Triangle& b) { return a.p0 == b.p0 && a.p1 == b.p1; }

template <class T>
long long times(const std::vector<T>& asked, const T& about) {
  return std::ranges::count_if(asked, [&](const T& one) { return same(one, about); });
}

long long times_asked(const Tested& log, const pt::Primitives& primitives, int i) {
  return primitives.is_triangle(i) ? times(log.triangles, primitives.triangle(i))
                                   : times(log.spheres, primitives.sphere(i));
}

// Boxes over few primitives, none larger than it needs to be, so that most are not entered.
Wanted tight() { return {.padding = 0, .max_leaf = 3}; }

PROMISE(hit_bvh, tests_few_primitives) {
  for (const bool any : {false, true}) {
    for_all([=] {
      const Case c = *some_tree(tight());
      const Tested log = tested_by(c, any);
      for (const pt::BvhNode& node : c.bvh.nodes) {
        // A tree of one leaf has no box above the primitives that would be worth a test.
        if (!node.is_leaf() || c.bvh.nodes.size() == 1 || pt::hit_box(node.box, c.ray)) continue;
        for (int i = node.first; i < node.first + node.count; ++i) {
          expect_equal("tests of primitive " + std::to_string(c.bvh.order[i]) +
                           ", whose leaf the ray does not enter",
                       times_asked(log, c.primitives, c.bvh.order[i]), 0);
        }
      }
    });
  }
}

PROMISE(hit_bvh, tests_no_box_twice) {
  for (const bool any : {false, true}) {
    for_all([=] {
      const Case c = *some_tree({.most = 25, .max_leaf = 3});
      const Tested log = tested_by(c, any);
      for (std::size_t i = 0; i < c.bvh.nodes.size(); ++i) {
        const pt::Box& box = c.bvh.nodes[i].box;
        const long long equal = std::ranges::count_if(
            c.bvh.nodes, [&](const pt::BvhNode& node) { return same(node.box, box); });
        const long long asked = times(log.boxes, box);
        expect(asked <= equal, "at most one test of the box of node " + std::to_string(i),
               std::to_string(asked));
      }
      for (int i = 0; i < c.primitives.size(); ++i) {
        const long long asked = times_asked(log, c.primitives, i);
        expect(asked <= 1, "at most one test of primitive " + std::to_string(i),
               std::to_string(asked));
      }
    });
  }
}

PROMISE(hit_bvh, skips_what_lies_outside_the_ray) {
  for (const bool any : {false, true}) {
    for_all([=] {
      const Case c = *some_tree(tight());
      const Tested log = tested_by(c, any);
      for (const pt::BvhNode& node : c.bvh.nodes) {
        if (node.is_leaf() || pt::hit_box(node.box, c.ray)) continue;
        for (const int child : {node.left, node.right}) {
          const pt::Box& box = c.bvh.nodes[child].box;
          if (same(box, node.box)) continue;  // the log cannot tell the two apart
          expect_equal("tests of a box in a box that the ray does not enter", times(log.boxes, box),
                       0);
        }
      }
    });
  }
}

PROMISE(hit_bvh, skips_what_lies_behind_a_hit) {
  constexpr int kWalls = 64, kTrees = 20;
  for_all(
      [] {
        Many make(draw("seed", sampler_seed()));
        Case c;
        for (int i = 0; i < kWalls; ++i) {
          const double z = i;
          c.primitives.triangles.push_back(pt::flat_triangle({-9, -9, z}, {9, -9, z}, {0, 18, z}));
        }
        c.ray = {{0.3, 0.2, -5}, {0.01, -0.02, 1}};
        long long walls = 0;
        for (int tree = 0; tree < kTrees; ++tree) {
          TreeMaker maker{c.primitives, Shape::random, 1, 0, make};
          maker.bvh.order.resize(kWalls);
          std::iota(maker.bvh.order.begin(), maker.bvh.order.end(), 0);
          maker.build(0, kWalls);
          c.bvh = maker.bvh;
          walls += static_cast<long long>(tested_by(c, false).triangles.size());
        }
        const double mean = static_cast<double>(walls) / kTrees;
        expect(mean > 0 && 2 * mean < kWalls,
               "tests of fewer than " + std::to_string(kWalls / 2) + " walls a query",
               show(mean) + " of " + std::to_string(kWalls));
      },
      3);
}

PROMISE(hit_bvh, stops_at_any_hit) {
  for_all(
      [] {
        Case c = *some_tree({.spheres = false});
        c.ray.t_min = 0;
        c.ray.t_max = pt::kInfinity;
        if (!nearest_of_all(c)) return;
        const Tested log = tested_by(c, true);
        int after = -1;
        for (const pt::Triangle& triangle : log.triangles) {
          if (after >= 0 || pt::hit_triangle(triangle, c.ray)) ++after;
        }
        expect(after >= 0, "a test of a triangle that is hit", "none");
        expect_equal("triangles tested after one was hit", after, 0);
      },
      kCases);
}

}  // namespace
}  // namespace grader
