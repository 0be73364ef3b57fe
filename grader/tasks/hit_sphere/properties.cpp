#include "grader/check/language/property.h"
#include "grader/tasks/hit_sphere/inputs.h"
#include "pt/tasks/hit_sphere.h"

#include <array>
#include <optional>

namespace grader::check {
namespace {

using namespace hit_sphere_inputs;

// The case after `change`. It is drawn as one value, so that a failure shows the ray that failed.
template <class Case, class Change>
rc::Gen<Case> mapped(const rc::Gen<Case>& made, const Change& change) {
  return rc::gen::exec([=] { return change(*made); });
}

pt::SurfaceHit expect_hit(const pt::Sphere& sphere, const pt::Ray& ray) {
  const auto hit = pt::hit_sphere(sphere, ray);
  expect(hit.has_value(), "a hit", "none");
  return *hit;
}

void expect_miss(const pt::Sphere& sphere, const pt::Ray& ray, const std::string& why) {
  const auto hit = pt::hit_sphere(sphere, ray);
  expect(!hit.has_value(), "no hit: " + why, hit ? show(*hit) : "");
}

// Accepts both points of the line. The promise finds_the_near_side judges which of them is
// returned.
void expect_either_point(const Chord& c) {
  const double t = expect_hit(c.sphere, c.ray).t;
  const bool far = std::abs(t - c.t_far) < std::abs(t - c.t_near);
  expect_near("t at the point aimed at", t, far ? c.t_far : c.t_near, c.slack);
}

PROMISE(hit_sphere, hits_where_it_is_aimed) {
  for (const Domain& domain : {Domain{.flat = kFlat, .far = kFar},
                               Domain{.radius = 1e9, .speed = 1e9, .flat = kFlat, .far = kFar}}) {
    for_all([=] { expect_either_point(*chord(From::outside, domain)); });
  }
  for_all([] { expect_either_point(*exactly(3)); }, 60);
  // The sphere and the ray of another call are forgotten.
  for (const auto& other : {&changed, &exchanged}) {
    for_all(
        [=] {
          const auto [before, now] = *in_turn(chord(From::outside), other);
          pt::hit_sphere(before.sphere, before.ray);
          expect_either_point(now);
        },
        200);
  }
  for_all([] {
    const Chord c = *touching();
    const auto hit = pt::hit_sphere(c.sphere, c.ray);
    if (hit) expect_near("t where the ray touches the sphere", hit->t, c.t_near, c.slack);
  });
  // Rays that nearly touch the sphere: they meet the surface at an angle of .011 to .3 degrees. The
  // second kind comes from the greatest distance, and is at most 1.2e-6 to 5e-6 radii inside.
  for (const Domain& domain : {Domain{.flat = std::sqrt(4 * kTouching), .round = kFlat, .far = 500},
                               Domain{.flat = 1.6e-3, .round = 3.2e-3, .near = 900, .far = kFar}}) {
    for_all([=] {
      const Chord c = *chord(From::outside, domain);
      const double t = expect_hit(c.sphere, c.ray).t;
      expect_near("the distance of the point from the centre, in radii",
                  distance_from_centre(c.sphere, c.ray, t), 1, kPrecision);
    });
  }
}

PROMISE(hit_sphere, misses_beside_the_sphere) {
  struct Beside {
    double low, high, far;
    int cases;
  };
  // A rounded radius shows only beside some spheres, and only if the ray nearly touches.
  for (const Beside& beside : {Beside{1e-3, 1e2, 100, 100}, Beside{2 * kTouching, 1e-3, 500, 50},
                               Beside{2 * kTouching, 2.1 * kTouching, 5, 120}}) {
    for_all(
        [=] {
          const Passing c = *passing(beside.low, beside.high, beside.far);
          expect_miss(c.sphere, c.ray, "the ray passes beside the sphere");
          // The promise hits_where_it_is_aimed judges whether tiny and huge spheres are hit.
          if (c.sphere.radius < 0.1 || c.sphere.radius > 10) return;
          expect(pt::hit_sphere(c.sphere, c.through).has_value(),
                 "a hit when the ray is turned to the sphere's centre", "none");
        },
        beside.cases);
  }
}

void expect_near_side(const Chord& c) {
  const double t = expect_hit(c.sphere, c.ray).t;
  expect(std::abs(t - c.t_near) < 0.5 * c.length(),
         "the nearer of the two points in the range, t about " + show(c.t_near),
         "t " + show(t) + ", and the farther one is at " + show(c.t_far));
}

PROMISE(hit_sphere, finds_the_near_side) {
  for_all([] {
    expect_near_side(*mapped(chord(From::outside), [](Chord made) {
      const double before = std::max(0.0, made.t_near - 3 * made.slack);
      made.ray.t_min = before * *rc::gen::element(0.0, 0.5, 1.0);
      made.ray.t_max = made.t_far + 3 * made.slack + made.length() * *magnitude(1e-6, 1e6);
      return made;
    }));
  });
  for_all(
      [] {
        const auto [before, now] = *in_turn(chord(From::outside), changed);
        pt::hit_sphere(before.sphere, before.ray);
        expect_near_side(now);
      },
      60);
}

// The ray starts on the surface, and its range a little later.
Chord beginning_later(Chord made) {
  made.ray.t_min = made.slack * *rc::gen::element(4.0, 100.0);
  return made;
}

void expect_far_side(const Chord& c, const std::string& from) {
  const auto hit = pt::hit_sphere(c.sphere, c.ray);
  expect(hit.has_value(), "a hit on the far side, from " + from, "none");
  expect_near("t at the far side, from " + from, hit->t, c.t_far, c.slack);
}

PROMISE(hit_sphere, hits_from_inside) {
  for_all([] { expect_far_side(*chord(From::inside), "inside the sphere"); });
  // A sphere of any size that is hit from outside is hit from inside, with any direction.
  for_all(
      [] {
        const Chord c = *chord(From::inside, {.radius = 1e9, .speed = 1e9});
        const pt::Ray from_outside{c.ray.at(c.t_near - c.length()), c.ray.direction};
        if (pt::hit_sphere(c.sphere, from_outside)) expect_far_side(c, "inside the sphere");
      },
      60);
  for_all([] { expect_far_side(*from_the_centre(), "the sphere's centre"); }, 20);
  for_all([] { expect_far_side(*exactly(0), "the middle of the chord"); }, 60);
  // The near point is before t_min, so that the far point is the hit. A thousand radii away it shows
  // rounding errors of a quotient from which the near one may not be made, and single precision in
  // the comparison with a t_max right behind the far point.
  for (const Domain& domain : {Domain{}, Domain{.speed = 3, .near = 10, .far = kFar}}) {
    for_all([=] {
      const Chord c = *mapped(chord(From::outside, domain), [](Chord made) {
        const double part = *rc::gen::element(0.0, 0.5, 1.0);
        made.ray.t_min = made.t_near + 3 * made.slack + part * (made.length() - 6 * made.slack);
        if (*whole(0, 1) == 0) made.ray.t_max = made.t_far + 3 * made.slack;
        return made;
      });
      const auto hit = pt::hit_sphere(c.sphere, c.ray);
      expect(hit.has_value(), "a hit on the far side, since the near one is before t_min", "none");
      expect_near("t at the far side, since the near one is before t_min", hit->t, c.t_far,
                  c.slack);
    });
  }
  // The ray starts at a point of the surface. This point may count as a hit or not.
  for (const auto& starting : {mapped(chord(From::inside),
                                      [](Chord made) {
                                        made.ray.origin = made.ray.at(made.t_near);
                                        return made;
                                      }),
                               exactly(1)}) {
    for_all([&] {
      const Chord c = *starting;
      const double t = expect_hit(c.sphere, c.ray).t;
      expect(t >= 0 && (t <= 2 * c.slack || std::abs(t - c.length()) <= 2 * c.slack),
             "t of the far side, " + show(c.length()) + ", or of the start itself", "t " + show(t));
    });
  }
  for_all([] {
    const Chord c = *mapped(exactly(1), beginning_later);
    expect_far_side(c, "a point of the surface, with t_min " + show(c.ray.t_min));
  });
}

// A ray whose line does not meet the sphere in the range of t. Often the range ends right before a
// point or begins right behind it, also where single precision does not see this.
Chord out_of_range(int kind) {
  const Domain domain{
      .radius = *rc::gen::element(10.0, 1e9), .near = *rc::gen::element(1e-5, 100.0), .far = kFar};
  Chord c = *chord(kind == 0 ? From::behind : kind == 1 ? From::inside : From::outside, domain);
  const double part = *rc::gen::element(0.0, 1.0) * *real(0.05, 0.95);
  const double way = std::max(0.0, c.t_near - 3 * c.slack);
  if (kind == 1) c.ray.t_max = (1 - part) * (c.t_far - 3 * c.slack);
  if (kind == 2) c.ray.t_max = (1 - part) * way;
  if (kind == 3) c.ray.t_min = c.t_far + 3 * c.slack + part * c.length();
  if (kind == 4) {
    const double inner = 0.5 * c.length() - 3 * c.slack;
    c.ray.t_min = 0.5 * (c.t_near + c.t_far) - (1 - part) * inner;
    c.ray.t_max = 0.5 * (c.t_near + c.t_far) + (1 - part) * inner;
  }
  return c;
}

PROMISE(hit_sphere, keeps_t_inside_the_ray) {
  for (int kind = 0; kind <= 4; ++kind) {
    for_all([=] {
      const Chord c = *rc::gen::exec([=] { return out_of_range(kind); });
      expect_miss(c.sphere, c.ray, "no point of the sphere is in the range of t");
    });
  }
  // From the far point outwards.
  for_all([] {
    const Chord c = *mapped(exactly(-1), beginning_later);
    expect_miss(c.sphere, c.ray, "the ray starts on the sphere and leaves it");
  });
  // A range that begins right before the near point and ends right behind it contains the point.
  for_all([] {
    const Chord c = *mapped(chord(From::outside), [](Chord made) {
      made.ray.t_min = made.t_near - 2 * made.slack;
      made.ray.t_max = made.t_near + 2 * made.slack;
      return made;
    });
    expect(pt::hit_sphere(c.sphere, c.ray).has_value(), "a hit in the range of t", "none");
  });
}

// Judges n at the point that is returned, which may be either of the two. n may be the difference
// from the centre, divided by its length or by the radius.
void expect_outward_unit(const Chord& c, const pt::SurfaceHit& hit) {
  const pt::Vec3 from_centre = c.ray.at(hit.t) - c.sphere.center;
  const double size = length(from_centre) / c.sphere.radius;
  const double n_size = length(hit.n);
  expect(std::abs(n_size - 1) <= 2 * kPrecision || std::abs(n_size - size) <= 2 * kPrecision,
         "an n of length 1", "the length " + show(n_size));
  expect_near("n, which points from the centre to the point at t", hit.n / n_size,
              normalize(from_centre), 2 * kPrecision);
}

PROMISE(hit_sphere, returns_the_outward_unit_normal) {
  for (const double speed : {1.0, 1e9}) {
    for_all([=] {
      const Chord c = *chord(From::outside, {.speed = speed});
      expect_outward_unit(c, expect_hit(c.sphere, c.ray));
    });
  }
  // From the middle of a chord or the centre, and rays that touch the sphere.
  for (const auto& special : {exactly(0), from_the_centre(), touching()}) {
    for_all(
        [&] {
          const Chord c = *special;
          if (const auto hit = pt::hit_sphere(c.sphere, c.ray)) expect_outward_unit(c, *hit);
        },
        60);
  }
  // Seen from inside. The promise hits_from_inside judges whether there is a hit.
  for (const From from : {From::inside, From::outside}) {
    for_all([=] {
      const Chord c = *mapped(chord(from, {.radius = 1e9}), [=](Chord made) {
        if (from == From::outside) made.ray.t_min = 0.5 * (made.t_near + made.t_far);
        return made;
      });
      const auto hit = pt::hit_sphere(c.sphere, c.ray);
      if (hit) expect_outward_unit(c, *hit);
    });
  }
}

// The same line with a direction of another length. The answer is compared with the task's own
// answer for a unit direction, not with the true one.
struct Scaled {
  Chord unit;
  double factor;
  pt::Ray ray;
};

void showValue(const Scaled& scaled, std::ostream& out) {
  show_lines(out, scaled.unit.sphere, scaled.ray);
}

Scaled scaled(const Chord& c) {
  const double factor = *any_length();
  return {c,
          factor,
          {c.ray.origin, factor * c.ray.direction, c.ray.t_min / factor, c.ray.t_max / factor}};
}

// Returns whether t is within a factor of two of one of the two points.
bool is_somewhere_near(const Chord& c, double t) {
  const auto is_near = [&](double point) { return t > point / 2 && t < 2 * point; };
  return is_near(c.t_near) || is_near(c.t_far);
}

void expect_scaled(const Scaled& c) {
  const auto hit = pt::hit_sphere(c.unit.sphere, c.ray);
  const auto unit = pt::hit_sphere(c.unit.sphere, c.unit.ray);
  expect(hit.has_value() == unit.has_value(),
         unit ? "a hit, as with a unit direction" : "no hit, as with a unit direction",
         hit ? show(*hit) : "none");
  if (!hit) return;
  // Other promises judge which point it is; no constant is near either point.
  expect(is_somewhere_near(c.unit, unit->t),
         "a hit at the sphere with a unit direction, t about " + show(c.unit.t_near) + " or " +
             show(c.unit.t_far),
         "t " + show(unit->t));
  expect_near("t times the direction's length", hit->t * c.factor, unit->t, 2 * c.unit.slack);
}

PROMISE(hit_sphere, works_for_directions_of_any_length) {
  for_all([] {
    const Scaled c = *rc::gen::exec([] { return scaled(*chord(From::outside)); });
    expect_scaled(c);
    expect(pt::hit_sphere(c.unit.sphere, c.unit.ray).has_value(), "a hit with a unit direction",
           "none");
  });
  // A range that ends in the sphere, or behind it.
  for (const double end : {0.25, 1.5}) {
    for_all(
        [=] {
          expect_scaled(*rc::gen::exec([=] {
            const Domain domain{.radius = *rc::gen::element(10.0, 1e9)};
            const auto froms = rc::gen::element(From::outside, From::inside, From::behind);
            Chord c = *chord(*froms, domain);
            c.ray.t_max = std::max(c.t_near, 0.0) + end * c.length();
            c.ray.t_min = *rc::gen::element(0.0, 0.5, 1.0) * std::max(0.0, c.t_at(1.5));
            return scaled(c);
          }));
        },
        end < 1 ? 80 : 30);
  }
  // Rays that miss, by the range of t or beside the sphere.
  for_all(
      [] {
        expect_scaled(*rc::gen::exec([] {
          const int kind = *whole(0, 7);
          if (kind <= 4) return scaled(out_of_range(kind));
          const Passing c = *passing(1e-3, 1e2, 100);
          return scaled({.sphere = c.sphere, .ray = c.ray, .t_near = 0, .t_far = 0, .slack = 0});
        }));
      },
      100);
}

void expect_on_the_sphere(const Aimed& aimed) {
  const double t = expect_hit(aimed.sphere, aimed.ray).t;
  expect_near("the distance of the point from the surface, in radii", off_the_sphere(aimed, t), 0,
              kPrecision);
}

PROMISE(hit_sphere, stays_accurate_at_a_distance) {
  for_all([] { expect_on_the_sphere(*aimed_from(1, 998)); });
}

PROMISE(hit_sphere, stays_accurate_at_any_distance_bonus) {
  for_all([] { expect_on_the_sphere(*aimed_from(1e6, 1e7)); });
}

}  // namespace
}  // namespace grader::check
