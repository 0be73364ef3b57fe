#include "grader/check/language/property.h"
#include "grader/tasks/hit_box/exact.h"
#include "grader/tasks/hit_box/inputs.h"

#include <algorithm>

#include <fmt/format.h>

namespace grader::check {
namespace {

using namespace hit_box_inputs;

std::string show(const std::optional<pt::Interval>& interval) {
  return interval ? "t from " + check::show(interval->min) + " to " + check::show(interval->max)
                  : "no interval";
}

// Where the ray is in the box, in words.
std::string between(const Part& part) {
  return fmt::format("from t = {} to {}", brief(rounded(part.enter.low)),
                     brief(rounded(part.leave.high)));
}

pt::Interval expect_any(const Case& c) {
  const auto interval = call(c);
  if (!interval) {
    fail("", show(interval), "an interval: the ray is in the box " + between(expected(c, 0)));
  }
  return *interval;
}

void expect_none(const Case& c) {
  const auto interval = call(c);
  if (!interval) return;
  const Part line = on_the_line(c.box, c.ray);
  fail("", show(interval),
       line.is_miss()
           ? "no interval: the ray passes beside the box"
           : "no interval: the line is in the box " + between(line) + ", outside the ray's range");
}

// A cube of width 2, and a ray through it that starts at a distance of 5.
const pt::Box kPlainBox{{-1, -1, -1}, {1, 1, 1}};
const pt::Ray kPlainRay{{0.1, 0.2, -5}, {0.02, -0.03, 1}};

// A task that gives the same answer for every ray does nothing, and then no promise holds.
void expect_that_it_looks() {
  pt::Ray beside = kPlainRay;
  beside.origin.x += 7;
  for (const auto& [ray, is_hit] : {std::pair{kPlainRay, true}, std::pair{beside, false}}) {
    if (testing::Test::HasFailure()) return;
    once([ray = ray, is_hit = is_hit] {
      const Case c = *rc::gen::just(Case{kPlainBox, ray});
      if (is_hit) {
        expect_any(c);
      } else {
        expect_none(c);
      }
    });
  }
}

// Returns whether the plainest interval is right. If it is wrong, gives_the_right_interval says so,
// and the other promises judge only whether there is an interval.
bool gives_intervals() {
  const auto plain = pt::hit_box(kPlainBox, kPlainRay);
  return plain && std::abs(plain->min - 4) < 0.1 && std::abs(plain->max - 6) < 0.1;
}

void expect_end(const std::string& what, double got, Ends allowed) {
  const double low = rounded(allowed.low), high = rounded(allowed.high);
  expect_near(what, got, 0.5 * low + 0.5 * high, (0.5 * high - 0.5 * low) + 1e-15 * std::abs(low));
}

void expect_ends(const Case& c, const pt::Interval& interval) {
  const Part part = expected(c);
  expect_end("where the ray enters", interval.min, part.enter);
  expect_end("where the ray leaves", interval.max, part.leave);
}

// Any answer is right for a case that is closer to a miss than the precision of the contract.
void hits(const Case& c) {
  if (expected(c).is_hit()) expect_any(c);
}

void misses(const Case& c) {
  if (!expected(c).is_miss()) return;
  expect_none(c);
}

void has_the_interval(const Case& c) {
  const pt::Interval interval = expect_any(c);
  if (gives_intervals()) expect_ends(c, interval);
}

void has_the_interval_if_it_hits(const Case& c) {
  if (expected(c).is_hit()) has_the_interval(c);
}

// For cases in which no number is rounded.
void has_the_exact_interval(const Case& c) {
  if (expected(c, 0).is_hit()) has_the_interval(c);
}

PROMISE(hit_box, hits_where_it_is_aimed) {
  expect_that_it_looks();
  all(aimed_inside(), hits, 200);
  all(aimed_at_a_side(), hits, 150);
  all(crossing_on_the_way(true), hits, 150);
}

PROMISE(hit_box, misses_beside_the_box) {
  expect_that_it_looks();
  all(passing(), misses, 200);
  all(crossing_on_the_way(false), misses, 150);
  all_after_another(passing(), changed, misses);
}

PROMISE(hit_box, gives_the_right_interval) {
  expect_that_it_looks();
  const auto ends = [](const Case& c) {
    if (expected(c).is_hit()) expect_ends(c, expect_any(c));
  };
  all(aimed_inside(), ends, 300);
  for (const double way : {1.0, 8.0}) all(through_the_middle(way), has_the_exact_interval, 50);
  all_after_another(aimed_inside(), changed, has_the_interval_if_it_hits);
  all_after_another(aimed_inside(), exchanged, has_the_interval_if_it_hits);
}

PROMISE(hit_box, begins_at_t_min_inside_the_box) {
  expect_that_it_looks();
  all(starting_inside(), has_the_interval_if_it_hits, 200);
  all(from_a_side(), has_the_exact_interval);
}

PROMISE(hit_box, keeps_to_the_rays_range) {
  expect_that_it_looks();
  all(aimed_inside().with(out_of_range), misses, 200);
  all(leaving(), misses, 200);
  const Boxes cut_on_both_sides = aimed_inside().with([](const Case& c) {
    const double first = *real(0.1, 0.4), last = *real(0.6, 0.9);
    return cut_inside(c, first, last);
  });
  all(cut_on_both_sides, [](const Case& c) {
    if (!expected(c).is_hit()) return;
    has_the_interval(c);
    const auto interval = call(c);
    expect(!gives_intervals() || (interval->min >= c.ray.t_min && interval->max <= c.ray.t_max),
           "inside the ray's range", show(interval));
  });
  const Boxes in_one_point = aimed_inside().with([](const Case& c) {
    const double at = *real(0.1, 0.9);
    return cut_inside(c, at, at);
  });
  all(in_one_point, has_the_interval_if_it_hits, 60);
  all(touching_the_range(), has_the_exact_interval);
}

PROMISE(hit_box, takes_rays_along_the_axes) {
  expect_that_it_looks();
  all(along_axes(false), has_the_interval_if_it_hits, 200);
  all(along_axes(true), misses, 200);
}

PROMISE(hit_box, works_for_directions_of_any_length) {
  expect_that_it_looks();
  all(aimed_inside(Extreme::length), has_the_interval_if_it_hits, 150);
  all(passing(Extreme::length), misses);
  all(crossing_on_the_way(true, Extreme::length), hits, 60);
  all(crossing_on_the_way(false, Extreme::length), misses, 60);
}

PROMISE(hit_box, works_at_every_scale) {
  expect_that_it_looks();
  all(aimed_inside(Extreme::scale), has_the_interval_if_it_hits, 150);
  all(aimed_at_a_side(Extreme::scale), hits);
  all(passing(Extreme::scale), misses, 150);
  all(leaving(Extreme::scale), misses);
  all(aimed_inside(Extreme::distance), has_the_interval_if_it_hits, 150);
  all(passing(Extreme::distance), misses);
  // All of it together: t is up to 1e28.
  all(aimed_inside(Extreme::all), has_the_interval_if_it_hits, 150);
  all(passing(Extreme::all), misses);
}

PROMISE(hit_box, takes_flat_boxes) {
  expect_that_it_looks();
  // Both planes of a sheet are in the same place, so that no rounding error separates them.
  all(at_a_sheet(), has_the_interval, 150);
  all(from_the_plane_of_a_sheet(false), has_the_interval);
  all(from_the_plane_of_a_sheet(true), misses);
  all(at_a_segment(), expect_any);
}

PROMISE(hit_box, never_misses_by_a_rounding_error_bonus) {
  expect_that_it_looks();
  all(grazing(), expect_any, 1000);
  all(separated_by_rounding(), expect_any, 1000);
  // A box that is never missed because it is far too wide is not robust.
  all(passing(), misses);
}

// A ray of which a component is almost 0, moved to a side of its slab and turned inwards.
std::optional<Case> in_the_plane_of_a_side(Case c) {
  const int axis = *whole(0, 2);
  double& d = c.ray.direction[axis];
  if (std::abs(d) > 1e-200) return std::nullopt;
  const double side = draw("the side", rc::gen::element(c.box.min[axis], c.box.max[axis]));
  c.ray.origin[axis] = side;
  pt::Ray in_the_side = c.ray;
  in_the_side.direction[axis] = 0;
  if (!expected(c.box, in_the_side).is_hit()) return std::nullopt;
  if (d != 0) d = std::copysign(d, side == c.box.max[axis] ? -1 : 1);
  return c;
}

PROMISE(hit_box, hits_rays_in_the_plane_of_a_side_bonus) {
  expect_that_it_looks();
  all(
      along_axes(false),
      [](const Case& c) {
        if (const auto moved = in_the_plane_of_a_side(c)) expect_any(*moved);
      },
      200);
  all(in_planes(), has_the_interval, 200);
  all(along_axes(true), misses);
}

}  // namespace
}  // namespace grader::check
