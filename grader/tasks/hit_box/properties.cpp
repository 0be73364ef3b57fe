#include "grader/check/language/property.h"
#include "grader/tasks/hit_box/exact.h"
#include "grader/tasks/hit_box/inputs.h"
#include "pt/tasks/hit_box.h"

#include <algorithm>

namespace grader::check {
namespace {

using namespace hit_box_inputs;

std::string show(const std::optional<pt::Interval>& interval) {
  return interval ? "t from " + check::show(interval->min) + " to " + check::show(interval->max)
                  : "no interval";
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
      const auto interval = pt::hit_box(c.box, c.ray);
      expect(interval.has_value() == is_hit, is_hit ? "an interval" : "no interval",
             show(interval));
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
  const double low = static_cast<double>(allowed.low), high = static_cast<double>(allowed.high);
  expect_near(what, got, 0.5 * low + 0.5 * high, (0.5 * high - 0.5 * low) + 1e-15 * std::abs(low));
}

// Any answer is right for a case that is closer to a miss than the precision of the contract.
void expect_hit(const Case& c) {
  if (!expected(c.box, c.ray).is_hit()) return;
  const auto interval = pt::hit_box(c.box, c.ray);
  expect(interval.has_value(), "an interval", "none");
}

void expect_miss(const Case& c) {
  if (!expected(c.box, c.ray).is_miss()) return;
  const auto interval = pt::hit_box(c.box, c.ray);
  expect(!interval.has_value(), "no interval", show(interval));
}

void expect_ends(const Case& c, const pt::Interval& interval) {
  const Part part = expected(c.box, c.ray);
  expect_end("where the ray enters", interval.min, part.enter);
  expect_end("where the ray leaves", interval.max, part.leave);
}

void expect_interval(const Case& c) {
  const auto interval = pt::hit_box(c.box, c.ray);
  expect(interval.has_value(), "an interval", "none");
  if (gives_intervals()) expect_ends(c, *interval);
}

void expect_hit_and_interval(const Case& c) {
  if (expected(c.box, c.ray).is_hit()) expect_interval(c);
}

// Judges the interval of a case in which no number is rounded.
void expect_without_rounding(const Case& c) {
  if (!expected(c.box, c.ray, 0).is_hit()) return;
  expect_interval(c);
}

// The call before this one is forgotten.
Case after_another(const InTurn<Case>& calls) {
  pt::hit_box(calls.before.box, calls.before.ray);
  return calls.now;
}

PROMISE(hit_box, hits_where_it_is_aimed) {
  expect_that_it_looks();
  for_all([] { expect_hit(*aimed_inside()); }, 200);
  for_all([] { expect_hit(*aimed_at_a_side()); }, 150);
  for_all([] { expect_hit(*crossing_on_the_way(true)); }, 150);
}

PROMISE(hit_box, misses_beside_the_box) {
  expect_that_it_looks();
  for_all([] { expect_miss(*passing()); }, 200);
  for_all([] { expect_miss(*crossing_on_the_way(false)); }, 150);
  for_all([] { expect_miss(after_another(*in_turn(passing(), changed))); });
}

PROMISE(hit_box, gives_the_right_interval) {
  expect_that_it_looks();
  for_all(
      [] {
        const Case c = *aimed_inside();
        if (!expected(c.box, c.ray).is_hit()) return;
        const auto interval = pt::hit_box(c.box, c.ray);
        expect(interval.has_value(), "an interval", "none");
        expect_ends(c, *interval);
      },
      300);
  for_all([] { expect_without_rounding(*through_the_middle(*rc::gen::element(1.0, 8.0))); });
  for_all([] { expect_hit_and_interval(after_another(*in_turn(aimed_inside(), changed))); });
  for_all([] { expect_hit_and_interval(after_another(*in_turn(aimed_inside(), exchanged))); });
}

PROMISE(hit_box, begins_at_t_min_inside_the_box) {
  expect_that_it_looks();
  for_all([] { expect_hit_and_interval(*starting_inside()); }, 200);
  for_all([] { expect_without_rounding(*from_a_side()); });
}

// A ray that starts behind the box, or whose range ends before the box or begins behind it.
rc::Gen<Case> out_of_range() {
  return rc::gen::exec([] {
    Case c = *aimed_inside();
    const Part line = on_the_line(c.box, c.ray);
    const auto enter = static_cast<double>(line.enter.low);
    const auto leave = static_cast<double>(line.leave.high);
    const double part = *rc::gen::element(0.5, 0.05, 1e-3, 1e-6);
    const int kind = *whole(0, 2);
    if (kind == 0) c.ray.t_min = leave * (1 + part);
    if (kind == 1 && enter > 0) c.ray.t_max = enter * (1 - part);
    // For an origin inside the box, t = 0 is inside it too, and no range can end before the box.
    // This ray starts behind the box instead.
    if (kind == 2 || (kind == 1 && !(enter > 0))) {
      c.ray = {c.ray.at(leave + part * (leave - enter)), c.ray.direction};
    }
    return c;
  });
}

// A ray through the box whose range is a single point inside.
rc::Gen<Case> in_one_point() {
  return rc::gen::exec([] {
    Case c = *aimed_inside();
    const Part part = expected(c.box, c.ray);
    const auto enter = static_cast<double>(part.enter.high);
    const auto leave = static_cast<double>(part.leave.low);
    c.ray.t_min = c.ray.t_max = enter + *real(0.1, 0.9) * (leave - enter);
    return c;
  });
}

PROMISE(hit_box, keeps_to_the_rays_range) {
  expect_that_it_looks();
  for_all([] { expect_miss(*out_of_range()); }, 200);
  for_all([] { expect_miss(*leaving()); }, 200);
  for_all([] {
    Case c = *aimed_inside();
    const Part part = expected(c.box, c.ray);
    if (!part.is_hit()) return;
    const auto enter = static_cast<double>(part.enter.high);
    const auto leave = static_cast<double>(part.leave.low);
    c.ray.t_min =
        enter + draw("t_min as a part of the way through", real(0.1, 0.4)) * (leave - enter);
    c.ray.t_max =
        enter + draw("t_max as a part of the way through", real(0.6, 0.9)) * (leave - enter);
    const auto interval = pt::hit_box(c.box, c.ray);
    expect(interval.has_value(), "an interval", "none");
    if (!gives_intervals()) return;
    expect_ends(c, *interval);
    expect(interval->min >= c.ray.t_min && interval->max <= c.ray.t_max, "inside the ray's range",
           show(interval));
  });
  for_all([] { expect_hit_and_interval(*in_one_point()); }, 60);
  for_all([] { expect_without_rounding(*touching_the_range()); });
}

PROMISE(hit_box, takes_rays_along_the_axes) {
  expect_that_it_looks();
  for_all([] { expect_hit_and_interval(*along_axes(false)); }, 200);
  for_all([] { expect_miss(*along_axes(true)); }, 200);
}

PROMISE(hit_box, works_for_directions_of_any_length) {
  expect_that_it_looks();
  for_all([] { expect_hit_and_interval(*aimed_inside(Extreme::length)); }, 150);
  for_all([] { expect_miss(*passing(Extreme::length)); }, 100);
  for_all([] { expect_hit(*crossing_on_the_way(true, Extreme::length)); }, 60);
  for_all([] { expect_miss(*crossing_on_the_way(false, Extreme::length)); }, 60);
}

PROMISE(hit_box, works_at_every_scale) {
  expect_that_it_looks();
  for_all([] { expect_hit_and_interval(*aimed_inside(Extreme::scale)); }, 150);
  for_all([] { expect_hit(*aimed_at_a_side(Extreme::scale)); });
  for_all([] { expect_miss(*passing(Extreme::scale)); }, 150);
  for_all([] { expect_miss(*leaving(Extreme::scale)); });
  for_all([] { expect_hit_and_interval(*aimed_inside(Extreme::distance)); }, 150);
  for_all([] { expect_miss(*passing(Extreme::distance)); });
  // All of it together: t is up to 1e28.
  for_all([] { expect_hit_and_interval(*aimed_inside(Extreme::all)); }, 150);
  for_all([] { expect_miss(*passing(Extreme::all)); });
}

PROMISE(hit_box, takes_flat_boxes) {
  expect_that_it_looks();
  // Both planes of a sheet are in the same place, so that no rounding error separates them.
  for_all([] { expect_interval(*at_a_sheet()); }, 150);
  for_all([] { expect_interval(*from_the_plane_of_a_sheet(false)); });
  for_all([] { expect_miss(*from_the_plane_of_a_sheet(true)); });
  for_all(
      [] {
        const Case c = *at_a_segment();
        expect(pt::hit_box(c.box, c.ray).has_value(), "an interval", "none");
      },
      100);
}

PROMISE(hit_box, never_misses_by_a_rounding_error_bonus) {
  expect_that_it_looks();
  for_all(
      [] {
        const Case c = *grazing();
        expect(pt::hit_box(c.box, c.ray).has_value(), "an interval", "none");
      },
      1000);
  for_all(
      [] {
        const Case c = *separated_by_rounding();
        expect(pt::hit_box(c.box, c.ray).has_value(), "an interval", "none");
      },
      300);
  // A box that is never missed because it is far too wide is not robust.
  for_all([] { expect_miss(*passing()); });
}

PROMISE(hit_box, hits_rays_in_the_plane_of_a_side_bonus) {
  expect_that_it_looks();
  for_all(
      [] {
        Case c = *along_axes(false);
        const int axis = *whole(0, 2);
        double& d = c.ray.direction[axis];
        if (std::abs(d) > 1e-200) return;
        const double side = draw("the side", rc::gen::element(c.box.min[axis], c.box.max[axis]));
        c.ray.origin[axis] = side;
        pt::Ray in_the_side = c.ray;
        in_the_side.direction[axis] = 0;
        if (!expected(c.box, in_the_side).is_hit()) return;
        if (d != 0) d = std::copysign(d, side == c.box.max[axis] ? -1 : 1);  // inwards
        expect(pt::hit_box(c.box, c.ray).has_value(), "an interval", "none");
      },
      200);
  for_all([] { expect_interval(*in_planes()); }, 200);
  for_all([] { expect_miss(*along_axes(true)); });
}

}  // namespace
}  // namespace grader::check
