#include "grader/property/property.h"
#include "grader/tasks/hit_triangle/cases.h"
#include "pt/tasks/hit_triangle.h"

#include <algorithm>

namespace grader {
namespace {

using namespace hit_triangle_cases;

pt::SurfaceHit expect_hit(const Aimed& aimed) {
  const auto hit = pt::hit_triangle(aimed.triangle, aimed.ray);
  expect(hit.has_value(), "a hit", "none");
  return *hit;
}

void expect_miss(const pt::Triangle& triangle, const pt::Ray& ray) {
  const auto hit = pt::hit_triangle(triangle, ray);
  expect(!hit.has_value(), "no hit", hit ? show(*hit) : "");
}

PROMISE(hit_triangle, hits_where_it_is_aimed) {
  for_all([] {
    const Aimed aimed = *aimed_inside();
    expect_near("t at the point aimed at", expect_hit(aimed).t, aimed.t, aimed.tolerance);
  });
  // Slivers, a thousand times as long as high.
  for_all([] {
    const Aimed aimed = *aimed_inside({.thin = 1e-3, .tilt = 1});
    expect_near("t at the point aimed at", expect_hit(aimed).t, aimed.t, aimed.tolerance);
  });
}

PROMISE(hit_triangle, misses_outside) {
  for_all(
      [] {
        const Aimed aimed = *aimed_outside();
        expect_miss(aimed.triangle, aimed.ray);
      },
      300);
}

PROMISE(hit_triangle, keeps_t_inside_the_ray) {
  for_all([] {
    Aimed aimed = *aimed_inside();
    aimed.ray.t_max = aimed.t * draw("t_max as a part of the way", real(0.05, 0.999));
    expect_miss(aimed.triangle, aimed.ray);
  });
  for_all([] {
    Aimed aimed = *aimed_inside();
    aimed.ray.t_min = aimed.t * draw("t_min in parts of the way", magnitude(1.001, 1e3));
    expect_miss(aimed.triangle, aimed.ray);
  });
  for_all([] {
    Aimed aimed = *aimed_inside();
    aimed.ray.direction = -aimed.ray.direction;
    aimed.ray.t_max = aimed.t * draw("t_max in parts of the way", magnitude(1e-1, 1e3));
    expect_miss(aimed.triangle, aimed.ray);
  });
  // A range that ends right beyond the point and begins right before it has the point in it.
  for_all([] {
    Aimed aimed = *aimed_inside();
    aimed.ray.t_min = aimed.t - std::max(1e-9 * aimed.t, aimed.tolerance);
    aimed.ray.t_max = aimed.t + std::max(1e-9 * aimed.t, aimed.tolerance);
    expect_hit(aimed);
  });
}

PROMISE(hit_triangle, interpolates_the_corner_normals) {
  for_all([] {
    const Aimed aimed = *aimed_inside();
    const pt::Vec3 n = expect_hit(aimed).n;
    expect_near("the direction of n", n / length(n), aimed.n, 1e-9);
  });
}

PROMISE(hit_triangle, returns_a_unit_normal) {
  for_all([] { expect_near("the length of n", length(expect_hit(*aimed_inside()).n), 1, 1e-12); });
}

PROMISE(hit_triangle, never_flips_the_normal) {
  for_all([] {
    Aimed aimed = *aimed_inside();
    const pt::Vec3 n = expect_hit(aimed).n;
    expect(dot(n, aimed.n) > 0, "n on the side of the corner normals", show(n));
    aimed.ray.origin = aimed.ray.at(2 * aimed.t);
    aimed.ray.direction = -aimed.ray.direction;
    const pt::Vec3 opposite = expect_hit(aimed).n;
    expect_near("n seen from the other side", opposite, n, 1e-9);
  });
}

PROMISE(hit_triangle, hits_both_faces) {
  for_all([] {
    Aimed aimed = *aimed_inside();
    expect_near("t", expect_hit(aimed).t, aimed.t, aimed.tolerance);
    std::swap(aimed.triangle.p1, aimed.triangle.p2);
    std::swap(aimed.triangle.n1, aimed.triangle.n2);
    const pt::SurfaceHit turned = expect_hit(aimed);
    expect_near("t with two corners exchanged", turned.t, aimed.t, aimed.tolerance);
    expect_near("n with two corners exchanged", turned.n / length(turned.n), aimed.n, 1e-9);
  });
}

PROMISE(hit_triangle, counts_t_in_the_directions_length) {
  for_all([] {
    Aimed aimed = *aimed_inside();
    const double factor = draw("the direction's factor", magnitude(1e-6, 1e6));
    aimed.ray.direction *= factor;
    aimed.ray.t_max = 1.5 * aimed.t / factor;
    expect_near("t times the factor", expect_hit(aimed).t * factor, aimed.t, aimed.tolerance);
  });
}

PROMISE(hit_triangle, works_at_every_scale) {
  for_all([] {
    const Aimed aimed = *aimed_inside({.size_low = 1e-6, .size_high = 1e6});
    expect_near("t at the point aimed at", expect_hit(aimed).t, aimed.t, aimed.tolerance);
  });
  // Of a fine mesh as the camera sees it, a million sizes away.
  for_all([] {
    const Aimed aimed = *aimed_inside({.size_low = 1e-6, .size_high = 1e-2, .far = 1e6});
    expect_near("t at the point aimed at", expect_hit(aimed).t, aimed.t, aimed.tolerance);
  });
}

PROMISE(hit_triangle, keeps_double_precision) {
  for_all([] {
    const Aimed aimed = *aimed_inside({.far = 10, .tilt = 1});
    const double size = length(aimed.triangle.p1 - aimed.triangle.p0);
    const double off = 1e-9 * (aimed.t + size / length(aimed.ray.direction));
    expect_near("t at the point aimed at", expect_hit(aimed).t, aimed.t, off);
  });
}

PROMISE(hit_triangle, rejects_what_has_no_area) {
  for_all(
      [] {
        const Degenerate c = *without_area();
        expect_miss(c.triangle, c.ray);
      },
      300);
  for_all(
      [] {
        const Degenerate c = *in_the_plane();
        expect_miss(c.triangle, c.ray);
      },
      300);
}

PROMISE(hit_triangle, leaves_no_gap_at_shared_edges_bonus) {
  for_all(
      [] {
        const Fan fan = *aimed_between();
        const bool hit = std::ranges::any_of(fan.triangles, [&](const pt::Triangle& triangle) {
          return pt::hit_triangle(triangle, fan.ray).has_value();
        });
        expect(hit, "a hit of at least one of the triangles", "none");
      },
      500);
}

}  // namespace
}  // namespace grader
