#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/generators/random_numbers.h"
#include "grader/check/generators/special.h"
#include "grader/check/language/cases.h"
#include "grader/tasks/hit_sphere/truth.h"
#include "pt/tasks/hit_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>

// Spheres, and rays along lines whose two points on the sphere are known. Lengths are in radii if
// nothing else is said.

namespace grader::check::hit_sphere_inputs {

// The contract's precision of a point and of a normal. A ray that is closer to touching the sphere
// than kTouching may be a hit or a miss.
inline constexpr double kPrecision = 1e-6;
inline constexpr double kTouching = 1e-8;

// Returns how far along the ray a point may be from the right one and still be within the precision
// of the surface. `half` is half the length of the chord. The flatter the ray, the larger the
// result.
inline double slack_along(double half) {
  const double thick = 2 * kPrecision + kPrecision * kPrecision;
  return half * half > thick ? half - std::sqrt(half * half - thick) : half + std::sqrt(thick);
}

// Half of the flattest chord whose two points can be distinguished, with a margin of about ten.
inline constexpr double kFlat = 5e-3;

// The largest distance from the origin to the near point: at most a thousand radii to the centre.
inline constexpr double kFar = 998;

struct Chord {
  pt::Sphere sphere;
  pt::Ray ray;
  double half = 1;       // half of its length: 1 through the centre, 0 where it only touches
  double t_near, t_far;  // where the line meets the sphere, in the ray's range or not
  double slack;          // slack_along, as a difference of t
  double length() const { return t_far - t_near; }
  double middle() const { return 0.5 * (t_near + t_far); }
  // Returns the t of a place that counts in chords: 1 is the near point, 2 the far point.
  double t_at(double place) const { return t_near + (place - 1) * length(); }
};

inline void showValue(const Chord& chord, std::ostream& out) {
  show_lines(out, chord.sphere, chord.ray);
}

using Chords = Cases<Chord>;

inline auto call(const Chord& c) { return pt::hit_sphere(c.sphere, c.ray); }
inline Off off(const Chord& c, const pt::SurfaceHit& hit) { return off(c.sphere, c.ray, hit); }

enum class From { outside, inside, behind };

// The ranges of a chord's numbers. The defaults are ordinary, so that a mistake with extreme
// numbers breaks only the promises about extreme numbers.
struct Domain {
  double radius = 10;  // from 1 / radius to radius
  double speed = 1;    // the direction's length, likewise
  double flat = 0.1;   // the shortest half chord
  double round = 1;    // the longest
  double near = 1e-5;  // the smallest distance
  double far = 30;     // the largest distance
};

// A number from 1 / range to range. In a large range it is often one of the ends.
inline double within(double range) {
  if (range > 10 && *whole(0, 2) > 0) return *rc::gen::element(1 / range, range);
  return *magnitude(1 / range, range);
}

// A sphere around the world's origin, beside it, or up to a million radii away.
inline pt::Sphere any_sphere(double range) {
  const double radius = within(range);
  if (*whole(0, 4) == 0) return {{}, radius};
  return {radius * *magnitude(1e-1, 1e6) * *point(1), radius};
}

// Returns the distance from the ray's origin to the near point. It is negative if the origin is
// behind the near point.
inline double start_of(From from, double half, const Domain& domain) {
  const double apart = 3 * slack_along(half), least = std::max(apart, domain.near);
  if (from == From::outside) return *magnitude(least, domain.far);
  if (from == From::behind) return -2 * half - *magnitude(least, domain.far);
  constexpr double kParts[] = {0.75, 0.25, 0.5, 0.0, 1.0};  // the plainest first
  const double part = *whole(0, 3) == 0 ? kParts[*whole(0, 4)] : *real(0, 1);
  return -apart - part * (2 * half - 2 * apart);
}

// A line along the frame's z that passes the centre at `offset` radii. `half` is half of its chord,
// or 0 if it passes beside the sphere. `start` is the distance from the origin to the near point.
inline Chord line_at(const pt::Sphere& sphere, const pt::Frame& frame, double offset, double half,
                     double start, double speed) {
  const pt::Vec3 middle = sphere.center + sphere.radius * offset * frame.x;
  const double unit = sphere.radius / speed;  // one radius as a difference of t
  return {sphere,
          {middle - sphere.radius * (start + half) * frame.z, speed * frame.z},
          half,
          unit * start,
          unit * (start + 2 * half),
          unit * slack_along(half)};
}

inline Chord chord_at(const pt::Sphere& sphere, const pt::Frame& frame, double half, double start,
                      double speed) {
  return line_at(sphere, frame, std::sqrt((1 - half) * (1 + half)), half, start, speed);
}

inline Chords chord(From from, Domain domain = {}) {
  return rc::gen::exec([=] {
    const pt::Sphere sphere = any_sphere(domain.radius);
    const pt::Frame frame = *any_frame();
    const double half =
        domain.round == 1 && *whole(0, 4) == 0 ? 1 : *magnitude(domain.flat, domain.round);
    const double start = start_of(from, half, domain);
    return chord_at(sphere, frame, half, start, within(domain.speed));
  });
}

// A ray from exactly the centre.
inline Chords from_the_centre() {
  return rc::gen::exec([] {
    const pt::Sphere sphere = any_sphere(10);
    return chord_at(sphere, *any_frame(), 1, -1, 1);
  });
}

// A ray along an axis that passes the centre at `offset` of `radius`, and starts `before` the point
// that is closest to the centre. All numbers are small whole numbers times a power of two, so that
// no method rounds the numbers that it compares.
inline Chord whole_chord(double radius, double offset, double half, double before) {
  const double scale = *power_of_two(1);
  const int axis = *whole(0, 2), other = (axis + *whole(1, 2)) % 3;
  pt::Vec3 along, aside;
  along[axis] = *rc::gen::element(1.0, -1.0);
  aside[other] = *rc::gen::element(1.0, -1.0);
  const pt::Vec3 center = *whole(0, 3) == 0 ? pt::Vec3{} : *whole_vector(3);
  return {{scale * center, scale * radius},
          {scale * (center + offset * aside - before * along), with_other_zeros(along)},
          half / radius,
          scale * (before - half),
          scale * (before + half),
          scale * radius * slack_along(half / radius)};
}

// `before` counts in half chords: -1 is exactly at the far point, 0 in the middle, 1 exactly at the
// near point, and more is outside.
inline Chords exactly(double before) {
  return rc::gen::exec([=] {
    const int kind = *whole(0, 2);
    if (kind == 0) return whole_chord(1, 0, 1, before);
    return kind == 1 ? whole_chord(5, 3, 4, 4 * before) : whole_chord(5, 4, 3, 3 * before);
  });
}

// A ray that touches the sphere, from outside. Both a hit there and a miss are right.
inline Chords touching() {
  return rc::gen::exec([] {
    const double radius = *whole(1, 5);
    return whole_chord(radius, radius, 0, *whole(1, 20));
  });
}

// The same with one number changed.
inline Chord changed(Chord chord) {
  const double radius = chord.sphere.radius;
  make_one_of(joined({changes_of(chord.sphere.center, 0.5 * radius),
                      {{&chord.sphere.radius, 0.5 * radius}},
                      changes_of(chord.ray, 0.5 * radius, chord.t_near)}));
  return chord;
}

// The same with two numbers of the centre, or of the ray, exchanged, or with others of the same sum.
inline Chord exchanged(Chord chord) {
  if (*whole(0, 1) == 0) {
    exchange_or_add_in({&chord.sphere.center});
  } else {
    exchange_or_add_in(chord.ray);
  }
  return chord;
}

// A line of a fixed stream of random numbers. It passes the centre at `offset` radii, which may be
// more than 1, and the ray starts `before` radii in front of the centre.
inline Chord some_line(RandomNumbers& make, double radius, double offset, double before,
                       double speed) {
  const pt::Sphere sphere{3 * radius * make.vector(-1, 1), radius};
  const pt::Vec3 along = normalize(make.vector(-1, 1) + pt::Vec3{0.1, 0.2, 0.3});
  const double half = std::sqrt(std::max(0.0, 1 - offset * offset));
  return line_at(sphere, pt::frame_from_normal(along), offset, half, before - half, speed);
}

inline Chord moved(Chord line, pt::Vec3 by) {
  line.sphere.center += by;
  line.ray.origin += by;
  return line;
}

// Ranges of a ray that starts outside the sphere, as places of Chord::t_at.
inline constexpr std::array<double, 2> kRanges[] = {{0, .5},   {.5, 1.5}, {0, 1.5}, {1.2, 1.8},
                                                    {1.5, 9},  {2.5, 9},  {.2, .7}, {1.5, 2.5},
                                                    {.5, 2.5}, {0, 2.5}};

// The same origin, and the direction of the centre.
inline Chord through_the_centre(Chord c) {
  const pt::Vec3 way = c.sphere.center - c.ray.origin;
  c.ray.direction = normalize(way);
  c.t_near = length(way) - c.sphere.radius;
  c.t_far = length(way) + c.sphere.radius;
  return c;
}

// The line passes the sphere at a distance of `low` to `high` from its surface. The ray starts up
// to `far` before or behind the sphere.
inline Chords passing(double low, double high, double far) {
  return rc::gen::exec([=] {
    const pt::Sphere sphere = any_sphere(*rc::gen::element(10.0, 1e9));
    const pt::Frame frame = *any_frame();
    const double beside = 1 + *magnitude(low, high), along = *real(-far, far);
    return line_at(sphere, frame, beside, 0, along, 1);
  });
}

// A ray from outside at a point of the visible half.
inline Chords aimed_from(double least, double most) {
  return rc::gen::exec([=] {
    const double radius = *magnitude(1e-3, 1e5);
    const pt::Sphere sphere{radius * *point(), radius};
    const pt::Frame frame = *rotation();
    const double half = std::cos(*real(-1, 1)), distance = *magnitude(least, most);
    return chord_at(sphere, frame, half, distance, 1);
  });
}

// A ground that is a sphere: from `radius` down to a hundredth of it in height are nothing special.
// The ray starts one unit above the ground and meets it at an angle of at least 3 degrees.
inline Chords ground(double radius) {
  return rc::gen::exec([=] {
    const pt::Frame frame = *any_frame();
    const double slope = *real(0.05, 0.5 * pt::kPi), side = std::cos(slope), down = std::sin(slope);
    const pt::Vec3 direction = frame.to_world({side, 0, -down});
    // The nearer root of t^2 - 2 (radius + 1) down t + 2 radius + 1, without a difference of large
    // numbers.
    const long double b = (radius + 1.0L) * down, c = 2.0L * radius + 1;
    const auto t = static_cast<double>(c / (b + std::sqrt(b * b - c)));
    return Chord{.sphere = {-radius * frame.z, radius},
                 .ray = {frame.z, direction},
                 .t_near = t,
                 .t_far = t,
                 .slack = 0};
  });
}

// A ray whose line does not meet the sphere in the range of t. Often the range ends right before a
// point or begins right behind it, also where single precision does not see this.
inline constexpr int kOutOfRange = 5;  // kinds
inline Chords out_of_range(int kind) {
  return rc::gen::exec([=] {
    const Domain domain{.radius = *rc::gen::element(10.0, 1e9),
                        .near = *rc::gen::element(1e-5, 100.0),
                        .far = kFar};
    Chord c = *chord(kind == 0 ? From::behind : kind == 1 ? From::inside : From::outside, domain);
    const double part = *rc::gen::element(0.0, 1.0) * *real(0.05, 0.95), room = 3 * c.slack;
    const double inner = (1 - part) * (0.5 * c.length() - room);
    if (kind == 1) c.ray.t_max = (1 - part) * (c.t_far - room);
    if (kind == 2) c.ray.t_max = (1 - part) * std::max(0.0, c.t_near - room);
    if (kind == 3) c.ray.t_min = c.t_far + room + part * c.length();
    if (kind == 4) c.ray.t_min = c.middle() - inner;
    if (kind == 4) c.ray.t_max = c.middle() + inner;
    return c;
  });
}

}  // namespace grader::check::hit_sphere_inputs
