#include "grader/property/generators.h"
#include "grader/property/property.h"
#include "pt/tasks/hit_sphere.h"

namespace grader {
namespace {

constexpr double kEpsilon = 0x1p-53;

// A sphere and a ray on a line through two of its points, which it meets at t_near and t_far,
// wherever the origin is: the two points are chosen first.
struct Chord {
  pt::Sphere sphere;
  pt::Ray ray;
  double t_near, t_far;
  pt::Vec3 n_near, n_far;
  double tolerance;  // of t: what rounding does to the plain quadratic, some ten times over
};

void showValue(const Chord& chord, std::ostream& out) { show_lines(out, chord.sphere, chord.ray); }

enum class From { outside, inside, behind };

// The two points are at least .3 radians apart, so that neither is grazed.
rc::Gen<Chord> chord(From from) {
  return rc::gen::exec([=] {
    const double radius = *magnitude(1e-3, 1e3);
    const pt::Vec3 center = *point();
    const double angle = *real(0.3, pt::kPi), roll = *real(-pt::kPi, pt::kPi);
    const pt::Vec3 n = *direction();
    const pt::Frame frame = pt::frame_from_normal(n);
    const pt::Vec3 tangent = std::cos(roll) * frame.x + std::sin(roll) * frame.y;
    const pt::Vec3 n_far = std::cos(angle) * n + std::sin(angle) * tangent;
    const pt::Vec3 along = normalize(n_far - n);

    // The distance from the origin to the near point; negative past it.
    const double length = 2 * radius * std::sin(angle / 2);
    const double start = from == From::outside  ? radius * *magnitude(1e-2, 1e2)
                         : from == From::inside ? -length * *real(0.02, 0.98)
                                                : -length - radius * *magnitude(1e-2, 1e2);
    const double speed = *magnitude(1e-3, 1e3);
    const pt::Vec3 near = center + radius * n;
    const pt::Vec3 origin = near - start * along;
    const double far_away = std::abs(start) + 2 * radius;
    const double error =
        64 * kEpsilon * (max_abs(center) + far_away * far_away / radius) / std::sin(angle / 2);
    return Chord{{center, radius},
                 {origin, speed * along},
                 start / speed,
                 (start + length) / speed,
                 n,
                 n_far,
                 error / speed};
  });
}

// A sphere, and a ray from outside at a point of its visible half.
struct Aimed {
  pt::Sphere sphere;
  pt::Ray ray;
  double t;
  double tolerance;
};

void showValue(const Aimed& aimed, std::ostream& out) { show_lines(out, aimed.sphere, aimed.ray); }

// The origin is `distance` radii from the point; the centre at most ten radii from the world's.
rc::Gen<Aimed> aimed_from(double least, double most, double max_tilt) {
  return rc::gen::exec([=] {
    const double radius = *magnitude(1e-3, 1e5);
    const pt::Sphere sphere{radius * *point(), radius};
    const pt::Vec3 n = *direction();
    const double tilt = *real(-max_tilt, max_tilt);
    const pt::Vec3 towards = -std::cos(tilt) * n + std::sin(tilt) * pt::frame_from_normal(n).x;
    const double distance = *magnitude(least, most);
    const double speed = *magnitude(1e-3, 1e3);
    const pt::Vec3 target = sphere.center + radius * n;
    const double error = 64 * kEpsilon * (20 + distance * distance) / std::cos(tilt);
    return Aimed{sphere,
                 {target - radius * distance * towards, speed * towards},
                 radius * distance / speed,
                 radius * error / speed};
  });
}

PROMISE(hit_sphere, hits_where_it_is_aimed) {
  for_all([] {
    const Aimed aimed = *aimed_from(1e-2, 1e2, 1.4);
    const auto hit = pt::hit_sphere(aimed.sphere, aimed.ray);
    expect(hit.has_value(), "a hit", "none");
    expect_near("t at the point aimed at", hit->t, aimed.t, aimed.tolerance);
  });
}

// A ray whose line passes the centre at more than the radius.
struct Passing {
  pt::Sphere sphere;
  pt::Ray ray;
};

void showValue(const Passing& passing, std::ostream& out) {
  show_lines(out, passing.sphere, passing.ray);
}

rc::Gen<Passing> passing() {
  return rc::gen::exec([] {
    const double radius = *magnitude(1e-3, 1e3);
    const pt::Sphere sphere{*point(), radius};
    const pt::Vec3 side = *direction();
    const double gap = *magnitude(1e-6, 1e2), along = *real(-100, 100);
    const double speed = *magnitude(1e-3, 1e3);
    const pt::Vec3 d = pt::frame_from_normal(side).x;
    return Passing{sphere,
                   {sphere.center + radius * (1 + gap) * side - radius * along * d, speed * d}};
  });
}

PROMISE(hit_sphere, misses_beside_the_sphere) {
  for_all([] {
    const Passing c = *passing();
    const auto hit = pt::hit_sphere(c.sphere, c.ray);
    expect(!hit.has_value(), "no hit", hit ? show(*hit) : "");
  });
}

PROMISE(hit_sphere, finds_the_near_side) {
  for_all([] {
    Chord c = *chord(From::outside);
    c.ray.t_min = draw("t_min as a part of the way", real(0, 0.9)) * c.t_near;
    c.ray.t_max = c.t_far * draw("t_max in far distances", magnitude(1.1, 1e6));
    const auto hit = pt::hit_sphere(c.sphere, c.ray);
    expect(hit.has_value(), "a hit", "none");
    expect_near("t of the nearer of two points", hit->t, c.t_near, c.tolerance);
  });
}

PROMISE(hit_sphere, hits_from_inside) {
  for_all([] {
    const Chord c = *chord(From::inside);
    const auto hit = pt::hit_sphere(c.sphere, c.ray);
    expect(hit.has_value(), "a hit on the far side", "none");
    expect_near("t at the far side", hit->t, c.t_far, c.tolerance);
  });
  // The near point lies before t_min, which leaves the far one.
  for_all([] {
    Chord c = *chord(From::outside);
    c.ray.t_min =
        c.t_near + draw("t_min as a part of the chord", real(0.05, 0.95)) * (c.t_far - c.t_near);
    const auto hit = pt::hit_sphere(c.sphere, c.ray);
    expect(hit.has_value(), "a hit on the far side", "none");
    expect_near("t at the far side", hit->t, c.t_far, c.tolerance);
  });
}

// Ranges of t in which the line does not meet the sphere.
rc::Gen<Chord> out_of_range() {
  return rc::gen::exec([] {
    const int kind = *whole(0, 4);
    Chord c = *chord(kind == 0 ? From::behind : kind == 1 ? From::inside : From::outside);
    const double part = *real(0.05, 0.95);
    const double length = c.t_far - c.t_near;
    if (kind == 1) c.ray.t_max = part * c.t_far;
    if (kind == 2) c.ray.t_max = part * c.t_near;
    if (kind == 3) c.ray.t_min = c.t_far + part * length;
    if (kind == 4) {
      c.ray.t_min = c.t_near + 0.5 * part * length;
      c.ray.t_max = c.ray.t_min + 0.4 * length;
    }
    return c;
  });
}

PROMISE(hit_sphere, keeps_t_inside_the_ray) {
  for_all(
      [] {
        const Chord c = *out_of_range();
        const auto hit = pt::hit_sphere(c.sphere, c.ray);
        expect(!hit.has_value(), "no hit in the range of t", hit ? show(*hit) : "");
      },
      300);
  // The range may end a little beyond the point.
  for_all([] {
    Aimed aimed = *aimed_from(1e-2, 1e2, 1.2);
    aimed.ray.t_max = aimed.t * (1 + 1e-6);
    aimed.ray.t_min = aimed.t * (1 - 1e-6);
    expect(pt::hit_sphere(aimed.sphere, aimed.ray).has_value(), "a hit in the range of t", "none");
  });
}

PROMISE(hit_sphere, returns_the_outward_unit_normal) {
  for (const From from : {From::outside, From::inside}) {
    for_all([=] {
      const Chord c = *chord(from);
      const auto hit = pt::hit_sphere(c.sphere, c.ray);
      expect(hit.has_value(), "a hit", "none");
      // Divided by the radius, n is as long as the point is far from the centre.
      const double slack = 1e-12 + 2 * c.tolerance * length(c.ray.direction) / c.sphere.radius;
      expect_near("the length of n", length(hit->n), 1, slack);
      expect_near("n", hit->n, from == From::outside ? c.n_near : c.n_far, slack);
    });
  }
}

PROMISE(hit_sphere, counts_t_in_the_directions_length) {
  for_all([] {
    const Chord c = *chord(From::outside);
    const double factor = draw("the direction's factor", magnitude(1e-6, 1e6));
    const pt::Ray scaled{c.ray.origin, factor * c.ray.direction, 0, 1.5 * c.t_far / factor};
    const auto hit = pt::hit_sphere(c.sphere, scaled);
    expect(hit.has_value(), "a hit", "none");
    expect_near("t times the factor", hit->t * factor, c.t_near, c.tolerance);
  });
}

void expect_on_the_sphere(const Aimed& aimed) {
  const auto hit = pt::hit_sphere(aimed.sphere, aimed.ray);
  expect(hit.has_value(), "a hit", "none");
  const double off = length(aimed.ray.at(hit->t) - aimed.sphere.center) / aimed.sphere.radius;
  expect_near("the distance of the point from the centre, in radii", off, 1, 1e-6);
}

PROMISE(hit_sphere, stays_accurate_at_a_distance) {
  for_all([] { expect_on_the_sphere(*aimed_from(1, 1e3, 1)); });
}

PROMISE(hit_sphere, stays_accurate_at_any_distance_bonus) {
  for_all([] { expect_on_the_sphere(*aimed_from(1e6, 1e7, 1)); });
}

}  // namespace
}  // namespace grader
