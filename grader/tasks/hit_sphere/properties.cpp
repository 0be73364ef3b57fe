#include "grader/check/language/property.h"
#include "grader/tasks/hit_sphere/inputs.h"
#include "pt/tasks/hit_sphere.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace hit_sphere_inputs;

using Judge = std::function<void(const Chord&)>;

pt::SurfaceHit expect_hit(const Chord& c, const std::string& where = "") {
  const auto hit = call(c);
  if (!hit) {
    const double t = c.t_near > c.ray.t_min ? c.t_near : c.t_far;
    fail("", "none", "a hit at t = " + brief(t) + where);
  }
  return *hit;
}

Judge hits(const std::string& where) {
  return [=](const Chord& c) { expect_hit(c, where); };
}

Judge misses(const std::string& why) {
  return [=](const Chord& c) {
    const auto hit = call(c);
    expect(!hit.has_value(), "no hit: " + why, hit ? show(*hit) : "");
  };
}

// Accepts both points of the line. The promise finds_the_near_side judges which of them is
// returned.
void is_at_either_point(const Chord& c) {
  const double t = expect_hit(c).t;
  const bool far = std::abs(t - c.t_far) < std::abs(t - c.t_near);
  expect_near("t at the point aimed at", t, far ? c.t_far : c.t_near, c.slack);
}

Judge is_at_the_far_point(const std::string& why) {
  return [=](const Chord& c) {
    expect_near("t at the far side, " + why, expect_hit(c, " on the far side, " + why).t, c.t_far,
                c.slack);
  };
}

void is_near(const Chord& c) {
  const double t = expect_hit(c).t;
  expect(std::abs(t - c.t_near) < 0.5 * c.length(),
         "the nearer of the two points in the range, t about " + show(c.t_near),
         "t " + show(t) + ", and the farther one is at " + show(c.t_far));
}

void is_on_the_sphere(const Chord& c) {
  expect_near("the distance of the point from the surface, in radii", off(c, expect_hit(c)).point,
              0, kPrecision);
}

PROMISE(hit_sphere, hits_where_it_is_aimed) {
  const Chords plain = chord(From::outside);
  all(chord(From::outside, {.flat = kFlat, .far = kFar}), is_at_either_point);
  all(chord(From::outside, {.radius = 1e9, .speed = 1e9, .flat = kFlat, .far = kFar}),
      is_at_either_point);
  all(exactly(3), is_at_either_point, 60);
  all_after_another(plain, changed, is_at_either_point, 200);
  all_after_another(plain, exchanged, is_at_either_point, 200);
  all(touching(), [](const Chord& c) {
    const auto hit = call(c);
    if (hit) expect_near("t where the ray touches the sphere", hit->t, c.t_near, c.slack);
  });
  // Rays that nearly touch the sphere: they meet the surface at an angle of .011 to .3 degrees. The
  // second kind comes from the greatest distance, and is at most 1.2e-6 to 5e-6 radii inside.
  all(chord(From::outside, {.flat = std::sqrt(4 * kTouching), .round = kFlat, .far = 500}),
      is_on_the_sphere);
  all(chord(From::outside, {.flat = 1.6e-3, .round = 3.2e-3, .near = 900, .far = kFar}),
      is_on_the_sphere);
}

PROMISE(hit_sphere, misses_beside_the_sphere) {
  const Judge beside = [](const Chord& c) {
    misses("the ray passes beside the sphere")(c);
    // The promise hits_where_it_is_aimed judges whether tiny and huge spheres are hit.
    if (c.sphere.radius < 0.1 || c.sphere.radius > 10) return;
    expect_hit(through_the_centre(c), " when the ray is turned to the sphere's centre");
  };
  // A rounded radius shows only beside some spheres, and only if the ray nearly touches.
  all(passing(1e-3, 1e2, 100), beside);
  all(passing(2 * kTouching, 1e-3, 500), beside, 50);
  all(passing(2 * kTouching, 2.1 * kTouching, 5), beside, 120);
}

PROMISE(hit_sphere, finds_the_near_side) {
  const auto with_both_points = [](Chord c) {
    c.ray.t_min = std::max(0.0, c.t_near - 3 * c.slack) * *rc::gen::element(0.0, 0.5, 1.0);
    c.ray.t_max = c.t_far + 3 * c.slack + c.length() * *magnitude(1e-6, 1e6);
    return c;
  };
  all(chord(From::outside).with(with_both_points), is_near);
  all_after_another(chord(From::outside), changed, is_near, 60);
}

// The ray starts on the surface, and its range a little later.
Chord beginning_later(Chord c) {
  c.ray.t_min = c.slack * *rc::gen::element(4.0, 100.0);
  return c;
}

Chord from_the_near_point(Chord c) {
  c.ray.origin = c.ray.at(c.t_near);
  c.t_far = c.length();
  c.t_near = 0;
  return c;
}

PROMISE(hit_sphere, hits_from_inside) {
  const Judge far = is_at_the_far_point("from inside the sphere");
  all(chord(From::inside), far);
  // A sphere of any size that is hit from outside is hit from inside, with any direction.
  const auto far_if_hit = [&](const Chord& c) {
    Chord from_outside = c;
    from_outside.ray.origin = c.ray.at(c.t_near - c.length());
    if (call(from_outside)) far(c);
  };
  all(chord(From::inside, {.radius = 1e9, .speed = 1e9}), far_if_hit, 60);
  all(from_the_centre(), is_at_the_far_point("from the sphere's centre"), 20);
  all(exactly(0), is_at_the_far_point("from the middle of the chord"), 60);
  // A thousand radii away the far point shows rounding errors of a quotient from which the near one may
  // not be made, and single precision in the comparison with a t_max right behind the far point.
  const auto without_the_near_point = [](Chord c) {
    const double part = *rc::gen::element(0.0, 0.5, 1.0);
    c.ray.t_min = c.t_near + 3 * c.slack + part * (c.length() - 6 * c.slack);
    if (*whole(0, 1) == 0) c.ray.t_max = c.t_far + 3 * c.slack;
    return c;
  };
  for (const Domain& domain : {Domain{}, Domain{.speed = 3, .near = 10, .far = kFar}}) {
    all(chord(From::outside, domain).with(without_the_near_point),
        is_at_the_far_point("since the near one is before t_min"));
  }
  // The ray starts at a point of the surface. This point may count as a hit or not.
  for (const Chords& starting : {chord(From::inside).with(from_the_near_point), exactly(1)}) {
    all(starting, [](const Chord& c) {
      const double t = expect_hit(c).t;
      expect(t >= 0 && (t <= 2 * c.slack || std::abs(t - c.length()) <= 2 * c.slack),
             "t of the far side, " + show(c.length()) + ", or of the start itself", "t " + show(t));
    });
  }
  all(exactly(1).with(beginning_later),
      is_at_the_far_point("from a point of the surface, with a later t_min"));
}

PROMISE(hit_sphere, keeps_t_inside_the_ray) {
  for (int kind = 0; kind < kOutOfRange; ++kind) {
    all(out_of_range(kind), misses("no point of the sphere is in the range of t"));
  }
  // From the far point outwards.
  all(exactly(-1).with(beginning_later), misses("the ray starts on the sphere and leaves it"));
  // A range that begins right before the near point and ends right behind it contains the point.
  const auto around_the_near_point = [](Chord c) {
    c.ray.t_min = c.t_near - 2 * c.slack;
    c.ray.t_max = c.t_near + 2 * c.slack;
    return c;
  };
  all(chord(From::outside).with(around_the_near_point), hits(" in the range of t"));
}

// Judges n at the point that is returned, which may be either of the two, or none: other promises
// judge whether there is a hit. n may be the difference from the centre, divided by its length or by
// the radius.
void has_outward_unit_normal(const Chord& c) {
  const auto hit = call(c);
  if (!hit) return;
  const pt::Vec3 from_centre = c.ray.at(hit->t) - c.sphere.center;
  const double size = length(from_centre) / c.sphere.radius;
  const double n_size = length(hit->n);
  expect(std::abs(n_size - 1) <= 2 * kPrecision || std::abs(n_size - size) <= 2 * kPrecision,
         "an n of length 1", "the length " + show(n_size));
  expect_near("n, from the centre to the point at the t returned, " + show(hit->t), hit->n / n_size,
              normalize(from_centre), 2 * kPrecision);
}

PROMISE(hit_sphere, returns_the_outward_unit_normal) {
  for (const double speed : {1.0, 1e9}) {
    all(chord(From::outside, {.speed = speed}), [](const Chord& c) {
      expect_hit(c);
      has_outward_unit_normal(c);
    });
  }
  // From the middle of a chord or the centre, and rays that touch the sphere.
  for (const Chords& special : {exactly(0), from_the_centre(), touching()}) {
    all(special, has_outward_unit_normal, 60);
  }
  // Seen from inside.
  all(chord(From::inside, {.radius = 1e9}), has_outward_unit_normal);
  const auto from_the_middle = [](Chord c) {
    c.ray.t_min = c.middle();
    return c;
  };
  all(chord(From::outside, {.radius = 1e9}).with(from_the_middle), has_outward_unit_normal);
}

// Returns whether t is within a factor of two of one of the two points.
bool is_somewhere_near(const Chord& c, double t) {
  const auto is_near = [&](double point) { return t > point / 2 && t < 2 * point; };
  return is_near(c.t_near) || is_near(c.t_far);
}

// The same line with a direction of another length. The answer is compared with the task's own
// answer for a unit direction, not with the true one.
void scales(const Chord& c) {
  const double factor = draw("times the length of the direction", any_length());
  Chord scaled = c;
  scaled.ray = {c.ray.origin, factor * c.ray.direction, c.ray.t_min / factor, c.ray.t_max / factor};
  const auto hit = call(scaled), unit = call(c);
  expect(hit.has_value() == unit.has_value(),
         unit ? "a hit, as with a unit direction" : "no hit, as with a unit direction",
         hit ? show(*hit) : "none");
  if (!hit) return;
  // Other promises judge which point it is; no constant is near either point.
  expect(is_somewhere_near(c, unit->t),
         "a hit at the sphere with a unit direction, t about " + show(c.t_near) + " or " +
             show(c.t_far),
         "t " + show(unit->t));
  expect_near("t times the direction's length", hit->t * factor, unit->t, 2 * c.slack);
}

PROMISE(hit_sphere, works_for_directions_of_any_length) {
  all(chord(From::outside), [](const Chord& c) {
    scales(c);
    expect_hit(c, " with a unit direction");
  });
  // A range that ends in the sphere, or behind it.
  for (const double end : {0.25, 1.5}) {
    const Chords chords = rc::gen::exec([=] {
      const Domain domain{.radius = *rc::gen::element(10.0, 1e9)};
      const From from = *rc::gen::element(From::outside, From::inside, From::behind);
      Chord c = *chord(from, domain);
      c.ray.t_max = std::max(c.t_near, 0.0) + end * c.length();
      c.ray.t_min = *rc::gen::element(0.0, 0.5, 1.0) * std::max(0.0, c.middle());
      return c;
    });
    all(chords, scales, end < 1 ? 80 : 30);
  }
  // Rays that miss, by the range of t or beside the sphere.
  for (int kind = 0; kind < kOutOfRange; ++kind) all(out_of_range(kind), scales, 12);
  all(passing(1e-3, 1e2, 100), scales, 40);
}

PROMISE(hit_sphere, stays_accurate_at_a_distance) { all(aimed_from(1, kFar), is_on_the_sphere); }

PROMISE(hit_sphere, stays_accurate_at_any_distance_bonus) {
  all(aimed_from(1e6, 1e7), is_on_the_sphere);
}

}  // namespace
}  // namespace grader::check
