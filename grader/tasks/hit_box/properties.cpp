#include "grader/property/property.h"
#include "grader/tasks/hit_box/cases.h"
#include "pt/tasks/hit_box.h"

#include <algorithm>

namespace grader {
namespace {

using namespace hit_box_cases;

std::string show(const std::optional<pt::Interval>& interval) {
  return interval ? "t from " + grader::show(interval->min) + " to " + grader::show(interval->max)
                  : "no interval";
}

// The part of the line that is in the box, from the origin on.
void expect_interval(const Case& c, const Part& line) {
  const auto interval = pt::hit_box(c.box, c.ray);
  expect(interval.has_value(), "an interval", "none");
  const double min = std::max(0.0, static_cast<double>(line.min));
  const double max = static_cast<double>(line.max);
  const double min_error = static_cast<double>(line.min_error) + 64 * kEpsilon * min;
  const double max_error = static_cast<double>(line.max_error) + 64 * kEpsilon * std::abs(max);
  expect_near("where the ray enters", interval->min, min, min_error);
  expect_near("where the ray leaves", interval->max, max, max_error);
}

void expect_miss(const Case& c) {
  const auto interval = pt::hit_box(c.box, c.ray);
  expect(!interval.has_value(), "no interval", show(interval));
}

PROMISE(hit_box, hits_where_it_is_aimed) {
  for_all(
      [] {
        const Case c = *aimed_inside();
        expect(pt::hit_box(c.box, c.ray).has_value(), "an interval", "none");
      },
      300);
  // At a point of a face that looks at the ray.
  for_all([] {
    const Case c = *rc::gen::exec([] {
      const pt::Box box = some_box();
      const int axis = *whole(0, 2);
      const double side = *rc::gen::element(0.0, 1.0);
      pt::Vec3 fraction{*real(0.05, 0.95), *real(0.05, 0.95), *real(0.05, 0.95)};
      pt::Vec3 d{*real(-1, 1), *real(-1, 1), *real(-1, 1)};
      fraction[axis] = side;
      d[axis] = side == 0 ? 1 : -1;
      return Case{box, through(box, point_in(box, fraction), d, *magnitude(1e-2, 100))};
    });
    expect(pt::hit_box(c.box, c.ray).has_value(), "an interval", "none");
  });
}

PROMISE(hit_box, misses_beside_the_box) {
  for_all([] { expect_miss(*passing()); }, 300);
}

PROMISE(hit_box, gives_the_right_interval) {
  for_all(
      [] {
        const Case c = *aimed_inside();
        expect_interval(c, expected(c.box, c.ray));
      },
      300);
}

PROMISE(hit_box, starts_inside) {
  for_all([] {
    const Case c = *rc::gen::exec([] {
      const pt::Box box = some_box();
      return Case{box, {well_inside(box), some_direction()}};
    });
    const auto interval = pt::hit_box(c.box, c.ray);
    expect(interval.has_value(), "an interval", "none");
    expect_near("where the interval begins", interval->min, 0, 0);
    const Part line = expected(c.box, c.ray);
    expect_interval(c, line);
  });
}

PROMISE(hit_box, keeps_to_the_rays_range) {
  for_all(
      [] {
        const Case c = *rc::gen::exec([] {
          Case made = *aimed_inside();
          const Part line = expected(made.box, made.ray);
          const double enter = static_cast<double>(line.min), leave = static_cast<double>(line.max);
          const int kind = *whole(0, 2);
          const double part = *real(0.05, 0.95);
          if (kind == 0) made.ray.t_min = leave * (1 + part);
          if (kind == 1) made.ray.t_max = enter * part;
          if (kind == 2) made.ray = {made.ray.at(leave * (1 + part)), made.ray.direction};
          // Some origins are in the box already: then nothing lies before t_max, and t = 0 is in
          // it.
          if (kind == 1 && !(enter > 0)) made.ray = {made.ray.at(leave * 2), made.ray.direction};
          return made;
        });
        expect_miss(c);
      },
      300);
  for_all([] {
    Case c = *aimed_inside();
    const Part line = expected(c.box, c.ray);
    const double enter = std::max(0.0, static_cast<double>(line.min));
    const double leave = static_cast<double>(line.max);
    c.ray.t_min =
        enter + draw("t_min as a part of the way through", real(0.1, 0.4)) * (leave - enter);
    c.ray.t_max =
        enter + draw("t_max as a part of the way through", real(0.6, 0.9)) * (leave - enter);
    expect_interval(c, {c.ray.t_min, c.ray.t_max});
    const auto interval = pt::hit_box(c.box, c.ray);
    expect(interval->min >= c.ray.t_min && interval->max <= c.ray.t_max, "inside the ray's range",
           show(interval));
  });
}

PROMISE(hit_box, takes_rays_along_the_axes) {
  for_all([] {
    const Case c = *along_axes(false);
    const Part line = expected(c.box, c.ray);
    if (!(line.max > 0)) return;  // all behind the origin
    expect_interval(c, line);
  });
  for_all([] { expect_miss(*along_axes(true)); });
}

PROMISE(hit_box, takes_flat_boxes) {
  // A sheet, met from either side.
  for_all([] {
    const Case c = *rc::gen::exec([] {
      pt::Box box = some_box();
      const int axis = *whole(0, 2);
      box.max[axis] = box.min[axis];
      const pt::Vec3 target = well_inside(box);
      pt::Vec3 d{*real(-1, 1), *real(-1, 1), *real(-1, 1)};
      d[axis] = *rc::gen::element(1.0, -1.0);
      if (*whole(0, 2) == 0) d[(axis + 1) % 3] = zero();
      return Case{box, through(box, target, *magnitude(1e-3, 1e3) * d, *magnitude(1e-2, 100))};
    });
    expect_interval(c, expected(c.box, c.ray));
  });
  // A segment or a point, at small whole numbers, met at a power of two: nothing is rounded.
  for_all([] {
    const Case c = *rc::gen::exec([] {
      pt::Vec3 p{*whole(-9, 9) * 1.0, *whole(-9, 9) * 1.0, *whole(-9, 9) * 1.0}, d;
      for (int i = 0; i < 3; ++i) d[i] = *rc::gen::element(1.0, -1.0, 2.0, -2.0, 4.0, -4.0);
      pt::Box box{p, p};
      const int axis = *whole(0, 2), length = *whole(0, 3);
      box.min[axis] -= length;
      box.max[axis] += length;
      return Case{box, {p - *rc::gen::element(1.0, 2.0, 8.0) * d, d}};
    });
    expect(pt::hit_box(c.box, c.ray).has_value(), "an interval", "none");
  });
}

PROMISE(hit_box, never_misses_by_a_rounding_error_bonus) {
  for_all(
      [] {
        const Case c = *grazing();
        expect(pt::hit_box(c.box, c.ray).has_value(), "an interval", "none");
      },
      2000);
}

PROMISE(hit_box, takes_rays_in_its_sides_bonus) {
  for_all(
      [] {
        Case c = *along_axes(false);
        const int axis = *whole(0, 2);
        if (c.ray.direction[axis] != 0) return;
        c.ray.origin[axis] = draw("the side", rc::gen::element(c.box.min[axis], c.box.max[axis]));
        if (expected(c.box, c.ray).max < 0) return;
        expect(pt::hit_box(c.box, c.ray).has_value(), "an interval", "none");
      },
      500);
}

}  // namespace
}  // namespace grader
