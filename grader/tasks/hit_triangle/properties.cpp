#include "grader/property/generators.h"
#include "grader/property/property.h"
#include "pt/tasks/hit_triangle.h"

#include <algorithm>
#include <array>

namespace grader {
namespace {

constexpr double kEpsilon = 0x1p-53;

struct Weights {
  double b0, b1, b2;  // sum to 1
};

// A triangle, and a ray at a known point of its plane.
struct Aimed {
  pt::Triangle triangle;
  pt::Ray ray;
  double t;
  pt::Vec3 n;        // the interpolated normal there
  double tolerance;  // of t: what rounding does to the plain determinants, some ten times over
};

void showValue(const Aimed& aimed, std::ostream& out) {
  show_lines(out, aimed.triangle, aimed.ray);
}

// How far the generator goes.
struct Range {
  double size_low = 1e-3, size_high = 1e3;  // of the first edge
  double thin = 1;                          // least height over length
  double far = 100;                         // largest distance, in sizes
  double tilt = 1.4;                        // from the plane's normal, radians
};

// Unit vectors within a radian of a common axis, which is on either side of the triangle; they
// never sum to almost nothing.
std::array<pt::Vec3, 3> corner_normals() {
  const pt::Frame around = *rotation();
  std::array<pt::Vec3, 3> normals;
  for (pt::Vec3& n : normals) {
    n = normalize(around.to_world({*real(-1, 1), *real(-1, 1), 1}));
  }
  return normals;
}

// Any rotation, or one whose z is so close to an axis that the other components are all but zero.
pt::Frame orientation() {
  if (*whole(0, 2) < 2) return *rotation();
  pt::Vec3 z;
  z[*whole(0, 2)] = *rc::gen::element(1.0, -1.0);
  return pt::frame_from_normal(normalize(z + *magnitude(1e-14, 1e-3) * *point(1)));
}

// The first edge has the length `size`; the third corner is at most one size along it and at least
// `thin` sizes away from it.
pt::Triangle triangle_of(double size, double thin) {
  const pt::Frame frame = orientation();
  const pt::Vec3 p0 = size * *point();
  const double along = *real(0, 1), height = *magnitude(thin, 1);
  const auto [n0, n1, n2] = corner_normals();
  return {p0, p0 + size * frame.x, p0 + size * (along * frame.x + height * frame.y), n0, n1, n2};
}

Aimed aimed_at(const pt::Triangle& triangle, Weights w, const Range& range) {
  const pt::Vec3 target = w.b0 * triangle.p0 + w.b1 * triangle.p1 + w.b2 * triangle.p2;
  const pt::Vec3 twice_area = geometric_normal(triangle);
  const pt::Frame plane = pt::frame_from_normal(normalize(twice_area));
  const double side = *rc::gen::element(1.0, -1.0);
  const double tilt = *real(-range.tilt, range.tilt), roll = *real(-pt::kPi, pt::kPi);
  const pt::Vec3 towards = plane.to_world(
      {std::sin(tilt) * std::cos(roll), std::sin(tilt) * std::sin(roll), side * std::cos(tilt)});
  const double size = length(triangle.p1 - triangle.p0);
  const double distance = size * *magnitude(1e-2, range.far);
  const double speed = *magnitude(1e-3, 1e3);
  const double height = length(twice_area) / size;
  const double error =
      64 * kEpsilon * (max_abs(target) + distance + size) * (size / height) / std::cos(tilt);
  const pt::Vec3 n = normalize(w.b0 * triangle.n0 + w.b1 * triangle.n1 + w.b2 * triangle.n2);
  return {
      triangle, {target - distance * towards, speed * towards}, distance / speed, n, error / speed};
}

// Well inside: no weight under 1/20.
Weights inside() {
  const double a = *real(0.05, 1), b = *real(0.05, 1), c = *real(0.05, 1);
  const double sum = a + b + c;
  return {0.9 * a / sum + 1.0 / 30, 0.9 * b / sum + 1.0 / 30, 0.9 * c / sum + 1.0 / 30};
}

rc::Gen<Aimed> aimed_inside(Range range = {}) {
  return rc::gen::exec([=] {
    const double size = *magnitude(range.size_low, range.size_high);
    const pt::Triangle triangle = triangle_of(size, range.thin < 1 ? range.thin : 0.5);
    return aimed_at(triangle, inside(), range);
  });
}

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

// At a point of the plane beyond one edge or two, by a thousandth of the triangle or by ten of it.
rc::Gen<Aimed> aimed_outside() {
  return rc::gen::exec([] {
    const double beyond = -*magnitude(1e-3, 10), other = *real(-3, 3);
    std::array<double, 3> b{beyond, other, 1 - beyond - other};
    std::rotate(b.begin(), b.begin() + *whole(0, 2), b.end());
    const double size = *magnitude(1e-3, 1e3);
    return aimed_at(triangle_of(size, 0.3), {b[0], b[1], b[2]}, {});
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

double small_whole() { return *whole(-2, 2); }

// Corners, origin and direction are small whole numbers and the direction's quotients are exact, so
// that every determinant is zero to the last bit.
struct Degenerate {
  pt::Triangle triangle;
  pt::Ray ray;
};

void showValue(const Degenerate& c, std::ostream& out) { show_lines(out, c.triangle, c.ray); }

const pt::Vec3 kUp{0, 0, 1};

bool divides_exactly(pt::Vec3 d) {
  const double largest = max_abs(d);
  return largest == 1 || largest == 2 || largest == 4;
}

rc::Gen<Degenerate> without_area() {
  return rc::gen::exec([] {
    const pt::Vec3 p{small_whole(), small_whole(), small_whole()};
    const pt::Vec3 step{1, small_whole(), small_whole()};
    std::array<pt::Vec3, 3> corners{p, p + small_whole() * step, p + small_whole() * step};
    std::rotate(corners.begin(), corners.begin() + *whole(0, 2), corners.end());
    const pt::Vec3 target = corners[*whole(0, 2)];
    const pt::Vec3 d{small_whole(), *rc::gen::element(1.0, -1.0, 2.0, -2.0), small_whole()};
    return Degenerate{{corners[0], corners[1], corners[2], kUp, kUp, kUp}, {target - 2 * d, d}};
  });
}

rc::Gen<Degenerate> in_the_plane() {
  return rc::gen::exec([] {
    const pt::Vec3 p{small_whole(), small_whole(), small_whole()};
    const pt::Vec3 e1{1, small_whole(), small_whole()}, e2{0, 2, small_whole()};
    const pt::Triangle triangle{p, p + e1, p + e2, kUp, kUp, kUp};
    const pt::Vec3 along = *rc::gen::element(e1, e2, -e1, -e2, e1 + e2, e1 - e2, e2 - e1);
    const pt::Vec3 d = divides_exactly(along) ? along : e2;
    const pt::Vec3 start = p + small_whole() * e1 + small_whole() * e2;
    return Degenerate{triangle, {start - 2 * d, d}};
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

// A fan of four triangles around a corner that they share, and a ray at the corner or at one of the
// edges that two of them share, from in front.
struct Fan {
  std::array<pt::Triangle, 4> triangles;
  pt::Ray ray;
};

void showValue(const Fan& fan, std::ostream& out) {
  for (const pt::Triangle& triangle : fan.triangles) out << show(triangle) << "\n";
  out << show(fan.ray);
}

rc::Gen<Fan> aimed_between() {
  return rc::gen::exec([] {
    const pt::Vec3 middle = *point();
    const pt::Frame frame = *rotation();
    std::array<pt::Vec3, 4> rim;
    for (int i = 0; i < 4; ++i) {
      const double angle = 0.5 * pt::kPi * i + *real(-0.5, 0.5), radius = *magnitude(0.3, 3);
      rim[i] = middle + frame.to_world(
                            {radius * std::cos(angle), radius * std::sin(angle), *real(-0.2, 0.2)});
    }
    Fan fan;
    for (int i = 0; i < 4; ++i) fan.triangles[i] = flat_triangle(middle, rim[i], rim[(i + 1) % 4]);
    const double part = *rc::gen::element(0.0, 1.0) * *real(0, 0.9);
    const pt::Vec3 target = middle + part * (rim[0] - middle);
    const pt::Vec3 origin = target + frame.to_world({*real(-3, 3), *real(-3, 3), *real(5, 10)});
    fan.ray = {origin, target - origin};
    return fan;
  });
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
