#include "grader/check/language/property.h"
#include "grader/tasks/hit_triangle/exact.h"
#include "grader/tasks/hit_triangle/inputs.h"

#include <algorithm>

#include <fmt/format.h>

namespace grader::check {
namespace {

using namespace hit_triangle_inputs;

using Judge = std::function<void(const Aimed&)>;

[[noreturn]] void fail_without_hit(const Aimed& aimed, const std::string& which = "") {
  const Place at = place_of(aimed.triangle, aimed.ray.at(aimed.t));
  fail("", "none",
       fmt::format("a hit at t = {}, at b0 {}, b1 {}, b2 {}{}", brief(aimed.t),
                   brief(rounded(at.b0)), brief(rounded(at.b1)), brief(rounded(at.b2)), which));
}

pt::SurfaceHit expect_hit(const Aimed& aimed, const std::string& which = "") {
  const auto hit = call(aimed);
  if (!hit) fail_without_hit(aimed, which);
  return *hit;
}

// Returns the hit of this ray or else of the ray that comes from the other side with the same t.
// The promise hits_both_faces judges whether both faces are hit.
std::optional<pt::SurfaceHit> hit_from_either_side(const Aimed& aimed) {
  const auto hit = call(aimed);
  return hit ? hit : call(aimed.from_the_other_side());
}

pt::SurfaceHit expect_hit_from_either_side(const Aimed& aimed) {
  const auto hit = hit_from_either_side(aimed);
  if (!hit) fail_without_hit(aimed);
  return *hit;
}

void expect_miss(const pt::Triangle& triangle, const pt::Ray& ray, const std::string& why) {
  const auto hit = pt::hit_triangle(triangle, ray);
  expect(!hit.has_value(), "no hit: " + why, hit ? show(*hit) : "");
}

Judge misses(const std::string& why) {
  return [=](const Aimed& aimed) { expect_miss(aimed.triangle, aimed.ray, why); };
}

void has_t(const Aimed& aimed) {
  expect_near("t at the point aimed at", expect_hit(aimed).t, aimed.t, aimed.tolerance);
}

void has_t_from_either_side(const Aimed& aimed) {
  expect_near("t at the point aimed at", expect_hit_from_either_side(aimed).t, aimed.t,
              2 * aimed.tolerance);
}

// For promises that do not judge t: the hit has to be near the triangle, so that no constant passes.
void expect_somewhere_near(double t, const Aimed& aimed, const std::string& which = "") {
  expect(t > aimed.t / 2 && t < 2 * aimed.t,
         fmt::format("a hit at the triangle, t between {} and {}{}", show(aimed.t / 2),
                     show(2 * aimed.t), which),
         "t " + show(t));
}

PROMISE(hit_triangle, hits_where_it_is_aimed) {
  all(aimed_inside(), has_t);
  all(aims({}, just_inside), has_t);
  all(aims(kPrecise, barely_inside), has_t);
  all(aims(kMostPrecise, a_hair_inside), has_t);
  // Slivers: triangles that are a thousand times as long as high.
  all(aimed_inside({.thin = 1e-3, .flat = 0.5}), has_t);
  // Rays that meet the plane at an angle of a millionth of a radian to ten degrees.
  all(aimed_inside(kFlat), has_t);
  // Slivers and flat angles together.
  all(aims(kFlatNeedle, in_the_middle), has_t);
  all(aims(kFlatSliver, in_the_middle), has_t, 40);
  all(aimed_inside(kVeryClose), has_t, 40);
  all(exactly(inside_in_eighths), has_t);
  // The triangle and the ray of another call are forgotten.
  for (const auto& other : {changed, exchanged})
    all_after_another(aimed_inside(), other, has_t, 60);
}

PROMISE(hit_triangle, misses_outside) {
  const Judge beside = misses("the ray is aimed beside the triangle");
  const auto only_outside = [&](const Aimed& aimed) {
    beside(aimed);
    const Aimed moved = at_the_middle(aimed);
    if (!hit_from_either_side(moved)) {
      fail_without_hit(moved, ", when the ray is moved to that point");
    }
  };
  all(aimed_outside(), only_outside, 150);
  all(exactly(outside_on_an_edges_line), beside, 200);
  const Judge just_beside = misses("the ray is aimed just beside the triangle");
  all(aims(kPrecise, barely_outside), just_beside, 120);
  all(aims(kMostPrecise, a_hair_outside), just_beside, 120);
}

PROMISE(hit_triangle, keeps_t_inside_the_ray) {
  const std::string none = "the point is not in the range of t";
  for (int kind = 0; kind <= 2; ++kind) {
    all(aimed_inside().with([=](const Aimed& made) { return out_of_range(made, kind); }),
        misses(kind < 2 ? none : "the triangle is behind the origin"));
  }
  all(exactly(inside_in_eighths).with(from_the_plane), misses(none));
  // A range that begins right before the point and ends right behind it contains the point.
  const auto around_the_point = [](Aimed made) {
    made.ray.t_min = std::max(0.0, made.t - 2 * made.tolerance);
    made.ray.t_max = made.t + 2 * made.tolerance;
    return made;
  };
  all(aimed_inside().with(around_the_point), expect_hit_from_either_side);
}

// Other promises judge the sign and the length of n; this one judges only the rest of its
// direction.
void expect_direction_of_n(const Aimed& aimed, const pt::SurfaceHit& hit) {
  const pt::Vec3 n = normalize(hit.n);
  expect_near("the direction of n", dot(n, aimed.n) < 0 ? -n : n, aimed.n, aimed.n_tolerance);
}

void has_n(const Aimed& aimed) { expect_direction_of_n(aimed, expect_hit_from_either_side(aimed)); }

void has_n_if_hit(const Aimed& aimed) {
  if (const auto hit = hit_from_either_side(aimed)) expect_direction_of_n(aimed, *hit);
}

PROMISE(hit_triangle, interpolates_the_corner_normals) {
  for (const auto where : {inside, just_inside}) {
    all(aims({}, where), has_n);
    if (testing::Test::HasFailure()) return;
  }
  all(exactly(inside_in_eighths), has_n_if_hit);
  // Another call is forgotten, also if only its normals were different.
  for (const auto& other : {changed, exchanged}) {
    all_after_another(aimed_inside(), other, has_n_if_hit, 60);
  }
  // Normals that disagree, and points so close to an edge that one weight is almost zero. Other
  // promises judge whether there is a hit.
  all(aims(kDisagreeing, barely_inside), has_n_if_hit);
  all(where_normals_cancel(), has_n_if_hit);
  all(aimed_inside(kAnyShape), has_n_if_hit);
}

PROMISE(hit_triangle, returns_a_unit_normal) {
  for (const Range& range : {Range{}, Range{.size = 1e6, .speed = 1e9}}) {
    bool any = false;
    all(aimed_inside(range), [&](const Aimed& aimed) {
      const auto hit = hit_from_either_side(aimed);
      if (!any && !hit) fail_without_hit(aimed);
      any = true;  // other promises judge later misses
      if (hit && range.speed == 1) expect_somewhere_near(hit->t, aimed);
      if (hit) expect_near("the length of n", length(hit->n), 1, kNormalPrecision);
    });
  }
}

void has_n_on_the_side_of_the_corner_normals(const Aimed& aimed, const std::string& which) {
  const auto hit = call(aimed);
  expect(!hit || dot(hit->n, aimed.n) > 0, "n on the side of the corner normals" + which,
         hit ? show(hit->n) : "");
}

PROMISE(hit_triangle, never_flips_the_normal) {
  all(aimed_inside(), [](const Aimed& aimed) {
    expect_somewhere_near(expect_hit_from_either_side(aimed).t, aimed);
    has_n_on_the_side_of_the_corner_normals(aimed, "");
    has_n_on_the_side_of_the_corner_normals(aimed.from_the_other_side(),
                                            " when the ray comes from the other side");
  });
}

PROMISE(hit_triangle, hits_both_faces) {
  all(aimed_inside(), [](Aimed aimed) {
    for (const char* corners : {"in their order", "with two of them exchanged"}) {
      for (const char* side : {"one side", "the other side"}) {
        const std::string which = std::string(", from ") + side + ", with the corners " + corners;
        expect_somewhere_near(expect_hit(aimed, which).t, aimed, which);
        aimed = aimed.from_the_other_side();
      }
      std::swap(aimed.triangle.p1, aimed.triangle.p2);
      std::swap(aimed.triangle.n1, aimed.triangle.n2);
    }
  });
}

// Compares the answer with the task's own answer for the unit direction, not with the true one.
void scales(const Aimed& aimed) {
  const auto hit = hit_from_either_side(aimed);
  const double speed = length(aimed.ray.direction);
  Aimed unit = longer(aimed, 1 / speed);
  unit.ray.t_min *= speed;
  unit.ray.t_max *= speed;
  const double t = expect_hit_from_either_side(unit).t;
  expect_somewhere_near(t, unit, " with a unit direction");
  expect(hit.has_value(), "a hit, as with a unit direction", "none");
  expect_near("t times the direction's length", hit->t * speed, t, 4 * unit.tolerance);
}

PROMISE(hit_triangle, works_for_directions_of_any_length) {
  all(aimed_inside().with([](const Aimed& made) { return scaled(made, *any_length()); }), scales);
  all(aimed_inside({.near = 1e-4, .far = 1}).with([](const Aimed& made) {
    return scaled(made, *rc::gen::element(2.0, 0.5, 1e9, 1e-9, 1e-8));
  }),
      scales);
  // A ray that misses does so with a direction of any length, and at any size.
  all(aimed_outside().with(at_any_size), misses("the ray is aimed beside the triangle"), 80);
  all(aimed_inside(kPrecise).with(
          [](const Aimed& made) { return out_of_range(at_any_size(made), *whole(0, 2)); }),
      misses("the point is not in the range of t"), 60);
}

PROMISE(hit_triangle, works_at_every_scale) {
  all(aimed_inside({.size = 1e6}), has_t_from_either_side);
  // A triangle of a fine mesh, a million of its sizes away from the camera; and a triangle far from
  // the world's origin.
  all(aimed_inside({.size = 1e6, .far = 1e6}), has_t_from_either_side);
  all(aimed_inside({.size = 1e2, .away = 1e4}), has_t_from_either_side);
  // From a million sizes away, also with a direction of a billionth: t is up to 1e22.
  all(aimed_inside({.near = 1e5, .far = 1e6}).with(at_any_size), has_t_from_either_side);
  // Needles, and rays that are almost parallel to the plane, at either end of the scale, with
  // directions at either end of theirs. A face that is hit at an ordinary size is hit at any size.
  for (const Range& range : {kNeedle, kFlattest}) {
    const auto as_at_an_ordinary_size = [](const Aimed& aimed) {
      if (call(ordinary(aimed))) {
        has_t(aimed);
      } else if (hit_from_either_side(ordinary(aimed))) {
        has_t_from_either_side(aimed);
      }
    };
    all(at_either_end(range), as_at_an_ordinary_size, 60);
  }
  all(aimed_outside({.size = 1e6}), misses("the ray is aimed beside the triangle"));
}

PROMISE(hit_triangle, keeps_double_precision) {
  all(aimed_inside({.away = 1, .near = 0.5, .far = 10, .flat = 0.57}), has_t_from_either_side);
}

PROMISE(hit_triangle, rejects_what_has_no_area) {
  // A triangle with an area is hit.
  all(aimed_inside(), expect_hit_from_either_side, 10);
  all(without_area(), misses("the triangle has no area"), 150);
  all(in_the_plane(), misses("the ray runs in the triangle's plane"), 150);
}

PROMISE(hit_triangle, leaves_no_gap_at_shared_edges_bonus) {
  const auto hits_one_of_them = [](const Fan& fan) {
    expect(is_hit(fan), "a hit of at least one of the triangles", "none");
    const pt::Ray away{fan.ray.origin, -fan.ray.direction};
    for (const pt::Triangle& triangle : fan.triangles) {
      expect_miss(triangle, away, "the ray goes the other way");
    }
  };
  all(aimed_between(), hits_one_of_them, 500);
}

}  // namespace
}  // namespace grader::check
