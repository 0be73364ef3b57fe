#include "grader/check/language/property.h"
#include "grader/check/mocks/counting.h"
#include "grader/tasks/hit_bvh/expected.h"
#include "grader/tasks/hit_bvh/inputs.h"
#include "grader/tasks/hit_bvh/queries.h"
#include "grader/tasks/hit_bvh/truth.h"
#include "pt/tasks/hit_bvh.h"

#include <algorithm>
#include <functional>

namespace grader::check {
namespace {

using namespace hit_bvh_inputs;

constexpr int kCases = 150;
const Wanted kAny{.copies = true, .any_scale = true};

// Returns whether the query walks the tree, and whether the promise holds so far. If not, this promise
// needs no other property.
bool walks() {
  static const testing::TestInfo* checked = nullptr;
  const auto* promise = testing::UnitTest::GetInstance()->current_test_info();
  if (promise != checked) once(expect_that_it_walks);
  checked = promise;
  return !testing::Test::HasFailure();
}

template <class Property>
void for_queries(const Property& property, int cases = kCases) {
  if (walks()) for_all(property, cases);
}

// Runs the check in scenes where the numbers of primitives, of places in the order and of nodes do
// not fit into 16 bits, or 17.
void for_large_numbers(const std::vector<AimedInGrid (*)()>& queries,
                       const std::function<void(const AimedInGrid&)>& check) {
  for (const auto& query : queries) {
    for_queries(
        [&] {
          const AimedInGrid aimed = *rc::gen::just(query());
          static const bool is_quick = is_quick_in_a_grid();
          if (is_quick) check(aimed);
        },
        1);
  }
}

// Another query of the same tree, and then the query itself. Both are judged.
template <class Check>
void expect_in_turn(const Check& check) {
  const auto [before, now] = *in_turn(some_tree({.most = 12}), changed);
  pt::hit_bvh(now.bvh, before.primitives, before.ray);
  pt::occluded_bvh(now.bvh, before.primitives, before.ray);
  check(now);
  check(Case{before.primitives, now.bvh, before.ray, before.how});
}

PROMISE(hit_bvh, finds_the_nearest_hit) {
  // The first scenes are the easiest to read: a promise that fails in them tries no others.
  for_queries([] { expect_nearest(*close_walls()); }, 40);
  for_queries([] { expect_nearest(*some_tree(kAny)); }, 2 * kCases);
  for_queries([] { expect_nearest(*walls_that_all_but_touch()); }, 60);
  for_queries([] { expect_nearest_at_an_end(*range_with_a_wall_at_its_end()); }, 40);
  for_queries([] { expect_nearest(*walls_with_one_t()); }, 40);
  for_queries([] { expect_as_all(*with_squares_in_halves()); }, 40);
  for_queries([] { expect_in_turn(expect_as_all); });
  for_queries(
      [] {
        const Case c = *large_tree();
        expect_nearest(c);
        expect_few_tests(c, tested_by(c, false));
      },
      6);
  for_large_numbers({last_in_the_largest_grid}, [](const AimedInGrid& aimed) {
    const Meeting right = meeting_of(aimed.grid->primitives, aimed.primitive(), aimed.ray());
    const auto hit = ask(aimed);
    expect(hit.has_value(), "a hit of " + aim_of(aimed), "no hit");
    expect_near("t of the nearest hit", hit->t, right.hit->t, t_error(right));
  });
}

PROMISE(hit_bvh, says_which_primitive) {
  const auto expect_own = [](const Case& c) {
    const Truth truth = truth_of(c);
    if (!truth.any() || !truth.is_clear) return;
    const auto hit = ask(c);
    expect(hit.has_value(), shown(truth), "none");
    expect(hit->primitive >= 0 && hit->primitive < c.primitives.size(), "one of the primitives",
           std::to_string(hit->primitive));
    const Meeting& own = truth.meetings[hit->primitive];
    expect(own.hit.has_value(), "a primitive that the ray hits",
           "primitive " + std::to_string(hit->primitive) + ", which it misses");
    expect_near("t, against the t of the primitive named", hit->t, own.hit->t, t_error(own));
    expect_near("n, against the n of the primitive named", hit->n, own.hit->n, n_error(own));
  };
  for_queries([=] { expect_own(*some_tree(kAny)); });
  for_queries([=] { expect_own(*walls_with_one_t()); }, 60);
  for_large_numbers({first_in_grid}, [](const AimedInGrid& aimed) {
    const auto hit = ask(aimed);
    expect(hit && hit->primitive == aimed.primitive(), "a hit of " + aim_of(aimed), shown(hit));
  });
}

PROMISE(hit_bvh, misses_what_is_not_there) {
  for_queries(
      [] {
        const Case c = *some_tree({.most = 8, .any_scale = true});
        const Truth truth = truth_of(c);
        if (truth.any() || !truth.is_clear) return;
        expect_as_all(c);
        expect_occluded_as_all(c);
      },
      2 * kCases);
}

PROMISE(hit_bvh, keeps_t_inside_the_ray) {
  for_queries([] {
    Case c = *some_tree({.all_of_ray = true, .any_scale = true});
    const Truth first = truth_of(c);
    if (!first.any()) return;
    // A range that ends before the first hit has no hit. If a range begins behind the first hit,
    // the next hit is the nearest.
    Case before = c, behind = c;
    before.ray.t_max = 0.999 * first.t();
    behind.ray.t_min = 1.001 * first.t();
    std::string asked;
    for (const Case& part : {before, behind}) {
      const Truth truth = truth_of(part);
      if (!truth.is_clear) continue;
      const std::string range =
          ", with t from " + show(part.ray.t_min) + " to " + show(part.ray.t_max);
      const std::string words = range + asked;
      asked = ", after the same ray" + range;
      const auto hit = ask(part);
      const bool right = hit && truth.any() ? std::abs(hit->t - truth.t()) <= t_error(truth)
                                            : hit.has_value() == truth.any();
      expect(right, shown(truth) + words, shown(hit));
      const bool occluded = occluded_bvh(part.bvh, part.primitives, part.ray);
      expect(occluded == truth.any(), "in the way: " + shown(truth) + words,
             occluded ? "something in the way" : "nothing in the way");
    }
  });
}

PROMISE(hit_bvh, takes_an_empty_tree) {
  for_queries(
      [] {
        const auto hit = pt::hit_bvh({}, {}, {{0, 0, 0}, {0, 0, 1}});
        expect(!hit.has_value(), "no hit", shown(hit));
        expect(!pt::occluded_bvh({}, {}, {{0, 0, 0}, {0, 0, 1}}), "nothing in the way",
               "something in the way");
      },
      1);
}

PROMISE(hit_bvh, takes_a_tree_of_any_shape) {
  const auto check = [](const Case& c) {
    expect_as_all(c);
    expect_occluded_as_all(c);
  };
  const Wanted wide{.least = 150, .most = 300, .max_leaf = 150, .min_leaf = 100};
  for_queries([=] { check(*with_tree({Shape::chain, Shape::random, Shape::balanced}, kAny)); });
  for_queries([=] { check(*with_tree({Shape::leaf}, {.most = 12})); }, 100);
  for_queries([=] { check(*with_tree({Shape::leaf, Shape::balanced}, wide)); }, 40);
  // More primitives in a leaf than fit into a byte, or into an array of some thousands.
  for (const int walls : {257, 513, 1025, 5000}) {
    for_queries([=] { check(*rc::gen::just(wide_leaf(walls, walls - 1))); }, 1);
  }
  for (const auto& part : {rc::gen::element(0.0, 0.5), rc::gen::just(0.5), real(0, 0.999)}) {
    for_queries([=] { check(*with_a_wide_leaf(part)); }, 2);
  }
  for (const Shape chain : {Shape::chain, Shape::left_chain, Shape::right_chain}) {
    for_queries([=] { check(*deep_tree(chain)); }, 1);
  }
  for_queries([=] { check(*deep_pile()); }, 3);
}

PROMISE(hit_bvh, finds_any_hit) {
  Wanted few = kAny;
  few.most = 12;
  for_queries([=] { expect_occluded_as_all(*some_tree(few)); }, 2 * kCases);
  for_queries([] { expect_occluded_at_an_end(*range_with_a_wall_at_its_end()); }, 40);
  for_queries([] { expect_occluded_as_all(*with_squares_in_halves()); }, 40);
  for_queries([] { expect_in_turn(expect_occluded_as_all); });
  for_queries(
      [] {
        const Case c = *large_tree();
        expect_occluded_as_all(c);
        expect_few_tests(c, tested_by(c, true));
      },
      6);
  for_large_numbers({first_in_grid, last_in_grid}, [](const AimedInGrid& aimed) {
    expect(is_occluded(aimed), "in the way: " + aim_of(aimed), "nothing in the way");
  });
}

PROMISE(hit_bvh, calls_hit_box_and_hit_primitive) {
  for_queries([] {
    const Case c = *some_tree();
    RandomNumbers make(draw("seed of the other ray", sampler_seed()));
    const pt::Ray other = some_clear_ray(c.primitives, {.all_of_ray = true}, make);
    if (!judge_answers) return;  // the submission's tasks answer, for the right ray only
    const Truth truth =
        truth_of(c.primitives, {other.origin, other.direction, c.ray.t_min, c.ray.t_max});
    const AnsweringFor another(other);
    const auto hit = ask(c);
    const bool occluded = occluded_bvh(c.bvh, c.primitives, c.ray);
    const std::string as_asked =
        ": hit_box and hit_primitive answer for another ray here, " + show(other);
    expect(hit.has_value() == truth.any(), shown(truth) + as_asked, shown(hit));
    if (hit)
      expect_near("t, as hit_primitive returns it" + as_asked, hit->t, truth.t(),
                  1e-12 * truth.t());
    expect(occluded == truth.any(), "in the way: " + shown(truth) + as_asked,
           occluded ? "something in the way" : "nothing in the way");
  });
}

// Small leaves, and boxes without padding, so that a ray enters only a few boxes.
Wanted tight() { return {.padding = 0, .max_leaf = 3}; }

PROMISE(hit_bvh, tests_few_primitives) {
  for (const bool any : {false, true}) {
    for_queries([=] { expect_only_entered_leaves(*some_tree(tight()), any); }, 100);
    for_queries([=] { expect_only_entered_leaves(*large_tree(), any); }, 3);
  }
}

PROMISE(hit_bvh, tests_no_box_twice) {
  for (const bool any : {false, true}) {
    for_queries([=] { expect_no_test_twice(*some_tree({.most = 25, .max_leaf = 3}), any); }, 100);
  }
}

PROMISE(hit_bvh, skips_what_lies_outside_the_ray) {
  for (const bool any : {false, true}) {
    for_queries([=] { expect_only_boxes_below_entered_ones(*some_tree(tight()), any); }, 100);
    for_queries([=] { expect_only_boxes_below_entered_ones(*large_tree(), any); }, 3);
  }
}

PROMISE(hit_bvh, skips_what_lies_behind_a_hit) {
  constexpr int kWalls = 64, kTrees = 20;
  const auto property = [](bool spheres, int in_a_leaf) {
    RandomNumbers make(draw("seed", sampler_seed()));
    Case c = walls_in_a_row(kWalls, spheres);
    long long walls = 0;
    for (int tree = 0; tree < kTrees; ++tree) {
      c.bvh = tree_in_order(c.primitives, Shape::random, make, in_a_leaf, in_a_leaf);
      const Tested log = tested_by(c, false);
      walls += std::ssize(log.triangles) + std::ssize(log.spheres);
    }
    const double mean = static_cast<double>(walls) / kTrees;
    const std::string what = spheres ? "spheres" : "walls";
    expect(mean > 0 && 2 * mean < kWalls,
           "tests of fewer than " + std::to_string(kWalls / 2) + " per query: 64 " + what +
               " stand one behind the other",
           show(mean) + " of 64 " + what + " tested, on average over 20 trees with " +
               std::to_string(in_a_leaf) + " in a leaf");
  };
  for (const bool spheres : {false, true}) {
    for (const int in_a_leaf : {1, 2}) for_queries([=] { property(spheres, in_a_leaf); }, 1);
  }
}

PROMISE(hit_bvh, stops_at_any_hit) {
  for_queries([] {
    const bool spheres = draw("with spheres", rc::gen::arbitrary<bool>());
    const Case c = *some_tree({.spheres = spheres, .all_of_ray = true});
    const Truth truth = truth_of(c);
    if (!truth.any() || !truth.is_clear) return;
    const Tested log = tested_by(c, true);
    int hits = 0, after = 0;
    const auto count = [&](const auto& asked, const auto& meets) {
      bool found = false;
      for (const auto& each : asked) {
        if (found) ++after;
        if (!meets(each)) continue;
        found = true;
        ++hits;
      }
    };
    count(log.triangles, [&](const auto& triangle) { return pt::hit_triangle(triangle, c.ray); });
    count(log.spheres, [&](const auto& sphere) { return pt::hit_sphere(sphere, c.ray); });
    expect(hits > 0, "a test of a primitive that is hit", "none");
    expect_equal("primitives tested after one was hit", std::max(after, hits - 1), 0);
  });
}

}  // namespace
}  // namespace grader::check
