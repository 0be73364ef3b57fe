#include "grader/check/language/property.h"
#include "grader/tasks/hit_triangle/exact.h"
#include "grader/tasks/hit_triangle/inputs.h"
#include "pt/tasks/hit_triangle.h"

#include <algorithm>

#include <fmt/format.h>

namespace grader::check {
namespace {

using namespace hit_triangle_inputs;

// The case after `change`. It is drawn as one value, so that a failure shows the ray that failed.
template <class Case, class Change>
rc::Gen<Case> mapped(const rc::Gen<Case>& made, const Change& change) {
  return rc::gen::exec([=] { return change(*made); });
}

pt::SurfaceHit expect_hit(const Aimed& aimed) {
  const auto hit = pt::hit_triangle(aimed.triangle, aimed.ray);
  expect(hit.has_value(), "a hit", "none");
  return *hit;
}

// Returns the hit of this ray or else of the ray that comes from the other side with the same t.
// The promise hits_both_faces judges whether both faces are hit.
std::optional<pt::SurfaceHit> hit_from_either_side(const Aimed& aimed) {
  const auto hit = pt::hit_triangle(aimed.triangle, aimed.ray);
  if (hit) return hit;
  pt::Ray opposite = aimed.ray;
  opposite.origin = aimed.ray.at(2 * aimed.t);
  opposite.direction = -aimed.ray.direction;
  return pt::hit_triangle(aimed.triangle, opposite);
}

pt::SurfaceHit expect_hit_from_either_side(const Aimed& aimed) {
  const auto hit = hit_from_either_side(aimed);
  expect(hit.has_value(), "a hit", "none");
  return *hit;
}

void expect_miss(const pt::Triangle& triangle, const pt::Ray& ray, const std::string& why) {
  const auto hit = pt::hit_triangle(triangle, ray);
  expect(!hit.has_value(), "no hit: " + why, hit ? show(*hit) : "");
}

void expect_t(const Aimed& aimed) {
  expect_near("t at the point aimed at", expect_hit(aimed).t, aimed.t, aimed.tolerance);
}

void expect_t_from_either_side(const Aimed& aimed) {
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
  for_all([] { expect_t(*aimed_inside()); });
  for_all([] { expect_t(*aimed_inside({}, just_inside)); });
  for_all([] { expect_t(*aimed_inside(kPrecise, barely_inside)); });
  for_all([] { expect_t(*aimed_inside(kMostPrecise, a_hair_inside)); });
  // Slivers: triangles that are a thousand times as long as high.
  for_all([] { expect_t(*aimed_inside({.thin = 1e-3, .flat = 0.5})); });
  // Rays that meet the plane at an angle of a millionth of a radian to ten degrees.
  for_all([] { expect_t(*aimed_inside(kFlat)); });
  // Slivers and flat angles together.
  for_all([] { expect_t(*aimed_inside(kFlatNeedle, in_the_middle)); });
  for_all([] { expect_t(*aimed_inside(kFlatSliver, in_the_middle)); }, 40);
  for_all([] { expect_t(*aimed_inside(kVeryClose)); }, 40);
  for_all([] { expect_t(*exactly(inside_in_eighths)); });
  // The triangle and the ray of another call are forgotten.
  for (const auto& other : {&changed, &exchanged}) {
    for_all(
        [=] {
          const auto [before, now] = *in_turn(aimed_inside(), other);
          pt::hit_triangle(before.triangle, before.ray);
          expect_t(now);
        },
        60);
  }
}

PROMISE(hit_triangle, misses_outside) {
  for_all(
      [] {
        const InAndOut aimed = *aimed_outside();
        expect_miss(aimed.out.triangle, aimed.out.ray, "the ray is aimed beside the triangle");
        expect(hit_from_either_side(aimed.in).has_value(),
               "a hit when the ray is turned to a point inside", "none");
      },
      150);
  for_all(
      [] {
        const Aimed aimed = *exactly(outside_on_an_edges_line);
        expect_miss(aimed.triangle, aimed.ray, "the ray is aimed beside the triangle");
      },
      200);
  for (const auto& [range, where] :
       {std::pair{kPrecise, &barely_outside}, std::pair{kMostPrecise, &a_hair_outside}}) {
    for_all(
        [range = range, where = where] {
          const Aimed aimed = (*aimed_outside(range, where)).out;
          expect_miss(aimed.triangle, aimed.ray, "the ray is aimed just beside the triangle");
        },
        120);
  }
}

PROMISE(hit_triangle, keeps_t_inside_the_ray) {
  const std::string none = "the point is not in the range of t";
  for (int kind = 0; kind <= 2; ++kind) {
    for_all([=] {
      const Aimed aimed =
          *mapped(aimed_inside(), [=](const Aimed& made) { return out_of_range(made, kind); });
      expect_miss(aimed.triangle, aimed.ray, kind < 2 ? none : "the triangle is behind the origin");
    });
  }
  for_all([=] {
    const Aimed aimed = *mapped(exactly(inside_in_eighths), from_the_plane);
    expect_miss(aimed.triangle, aimed.ray, none);
  });
  // A range that begins right before the point and ends right behind it contains the point.
  for_all([] {
    expect_hit_from_either_side(*mapped(aimed_inside(), [](Aimed made) {
      made.ray.t_min = std::max(0.0, made.t - 2 * made.tolerance);
      made.ray.t_max = made.t + 2 * made.tolerance;
      return made;
    }));
  });
}

// Other promises judge the sign and the length of n; this one judges only the rest of its
// direction.
void expect_direction_of_n(const Aimed& aimed, const pt::SurfaceHit& hit) {
  const pt::Vec3 n = normalize(hit.n);
  expect_near("the direction of n", dot(n, aimed.n) < 0 ? -n : n, aimed.n, aimed.n_tolerance);
}

PROMISE(hit_triangle, interpolates_the_corner_normals) {
  for (const auto where : {inside, just_inside}) {
    for_all([=] {
      const Aimed aimed = *aimed_inside({}, where);
      expect_direction_of_n(aimed, expect_hit_from_either_side(aimed));
    });
    if (testing::Test::HasFailure()) return;
  }
  for_all([] {
    const Aimed aimed = *exactly(inside_in_eighths);
    if (const auto hit = hit_from_either_side(aimed)) expect_direction_of_n(aimed, *hit);
  });
  // Another call is forgotten, also if only its normals were different.
  for (const auto& other : {&changed, &exchanged}) {
    for_all(
        [=] {
          const auto [before, now] = *in_turn(aimed_inside(), other);
          pt::hit_triangle(before.triangle, before.ray);
          if (const auto hit = hit_from_either_side(now)) expect_direction_of_n(now, *hit);
        },
        60);
  }
  // Normals that disagree, and points so close to an edge that one weight is almost zero. Other
  // promises judge whether there is a hit.
  for_all([] {
    const Aimed aimed = *aimed_inside(kDisagreeing, barely_inside);
    const auto hit = hit_from_either_side(aimed);
    if (hit) expect_direction_of_n(aimed, *hit);
  });
  for_all([] {
    const Aimed aimed = *where_normals_cancel();
    if (const auto hit = hit_from_either_side(aimed)) expect_direction_of_n(aimed, *hit);
  });
  for_all([] {
    const Aimed aimed = *aimed_inside(kAnyShape);
    if (const auto hit = hit_from_either_side(aimed)) expect_direction_of_n(aimed, *hit);
  });
}

PROMISE(hit_triangle, returns_a_unit_normal) {
  for (const Range& range : {Range{}, Range{.size = 1e6, .speed = 1e9}}) {
    bool any = false;
    for_all([&] {
      const Aimed aimed = *aimed_inside(range);
      const auto hit = hit_from_either_side(aimed);
      expect(any || hit.has_value(), "a hit", "none");
      any = true;  // other promises judge later misses
      if (hit && range.speed == 1) expect_somewhere_near(hit->t, aimed);
      if (hit) expect_near("the length of n", length(hit->n), 1, kNormalPrecision);
    });
  }
}

PROMISE(hit_triangle, never_flips_the_normal) {
  for_all([] {
    Aimed aimed = *aimed_inside();
    expect_somewhere_near(expect_hit_from_either_side(aimed).t, aimed);
    for (const char* side : {"", " when the ray comes from the other side"}) {
      const auto hit = pt::hit_triangle(aimed.triangle, aimed.ray);
      expect(!hit || dot(hit->n, aimed.n) > 0,
             std::string("n on the side of the corner normals") + side, hit ? show(hit->n) : "");
      aimed.ray.origin = aimed.ray.at(2 * aimed.t);
      aimed.ray.direction = -aimed.ray.direction;
    }
  });
}

PROMISE(hit_triangle, hits_both_faces) {
  for_all([] {
    Aimed aimed = *aimed_inside();
    for (const char* corners : {"in their order", "with two of them exchanged"}) {
      for (const char* side : {"one side", "the other side"}) {
        const auto hit = pt::hit_triangle(aimed.triangle, aimed.ray);
        const std::string which = std::string(" from ") + side + ", with the corners " + corners;
        expect(hit.has_value(), "a hit" + which, "none");
        expect_somewhere_near(hit->t, aimed, which);
        aimed.ray.origin = aimed.ray.at(2 * aimed.t);
        aimed.ray.direction = -aimed.ray.direction;
      }
      std::swap(aimed.triangle.p1, aimed.triangle.p2);
      std::swap(aimed.triangle.n1, aimed.triangle.n2);
    }
  });
}

// Compares the answer with the task's own answer for the unit direction, not with the true one.
void expect_scaled(const Aimed& aimed) {
  const auto hit = hit_from_either_side(aimed);
  const double speed = length(aimed.ray.direction);
  Aimed unit = aimed;
  unit.ray.direction = aimed.ray.direction / speed;
  unit.ray.t_min *= speed;
  unit.ray.t_max *= speed;
  unit.t *= speed;
  const double t = expect_hit_from_either_side(unit).t;
  expect_somewhere_near(t, unit, " with a unit direction");
  expect(hit.has_value(), "a hit, as with a unit direction", "none");
  expect_near("t times the direction's length", hit->t * speed, t, 4 * aimed.tolerance * speed);
}

PROMISE(hit_triangle, works_for_directions_of_any_length) {
  for_all([] {
    expect_scaled(
        *mapped(aimed_inside(), [](const Aimed& made) { return scaled(made, *any_length()); }));
  });
  for_all([] {
    expect_scaled(*mapped(aimed_inside({.near = 1e-4, .far = 1}), [](const Aimed& made) {
      return scaled(made, *rc::gen::element(2.0, 0.5, 1e9, 1e-9, 1e-8));
    }));
  });
  // A ray that misses does so with a direction of any length, and at any size.
  for_all(
      [] {
        const Aimed aimed = *rc::gen::exec([] { return at_any_size((*aimed_outside()).out); });
        expect_miss(aimed.triangle, aimed.ray, "the ray is aimed beside the triangle");
      },
      80);
  for_all(
      [] {
        const Aimed aimed = *mapped(aimed_inside(kPrecise), [](const Aimed& made) {
          return out_of_range(at_any_size(made), *whole(0, 2));
        });
        expect_miss(aimed.triangle, aimed.ray, "the point is not in the range of t");
      },
      60);
}

PROMISE(hit_triangle, works_at_every_scale) {
  for_all([] { expect_t_from_either_side(*aimed_inside({.size = 1e6})); });
  // A triangle of a fine mesh, a million of its sizes away from the camera; and a triangle far from
  // the world's origin.
  for_all([] { expect_t_from_either_side(*aimed_inside({.size = 1e6, .far = 1e6})); });
  for_all([] { expect_t_from_either_side(*aimed_inside({.size = 1e2, .away = 1e4})); });
  // From a million sizes away, also with a direction of a billionth: t is up to 1e22.
  for_all([] {
    expect_t_from_either_side(*mapped(aimed_inside({.near = 1e5, .far = 1e6}), at_any_size));
  });
  // Needles, and rays that are almost parallel to the plane, at either end of the scale, with
  // directions at either end of theirs. A face that is hit at an ordinary size is hit at any size.
  for (const Range& range : {kNeedle, kFlattest}) {
    for_all(
        [&] {
          const auto [ordinary, extreme] = *at_either_end(range);
          if (pt::hit_triangle(ordinary.triangle, ordinary.ray)) {
            expect_t(extreme);
          } else if (hit_from_either_side(ordinary)) {
            expect_t_from_either_side(extreme);
          }
        },
        60);
  }
  for_all([] {
    const InAndOut aimed = *aimed_outside({.size = 1e6});
    expect_miss(aimed.out.triangle, aimed.out.ray, "the ray is aimed beside the triangle");
  });
}

PROMISE(hit_triangle, keeps_double_precision) {
  for_all([] {
    expect_t_from_either_side(*aimed_inside({.away = 1, .near = 0.5, .far = 10, .flat = 0.57}));
  });
}

PROMISE(hit_triangle, rejects_what_has_no_area) {
  // A triangle with an area is hit.
  for_all([] { expect_hit_from_either_side(*aimed_inside()); }, 10);
  for_all(
      [] {
        const Degenerate c = *without_area();
        expect_miss(c.triangle, c.ray, "the triangle has no area");
      },
      150);
  for_all(
      [] {
        const Degenerate c = *in_the_plane();
        expect_miss(c.triangle, c.ray, "the ray runs in the triangle's plane");
      },
      150);
}

PROMISE(hit_triangle, leaves_no_gap_at_shared_edges_bonus) {
  for_all(
      [] {
        const Fan fan = *aimed_between();
        expect(is_hit(fan), "a hit of at least one of the triangles", "none");
        const pt::Ray away{fan.ray.origin, -fan.ray.direction};
        for (const pt::Triangle& triangle : fan.triangles) {
          expect_miss(triangle, away, "the ray goes the other way");
        }
      },
      500);
}

}  // namespace
}  // namespace grader::check
