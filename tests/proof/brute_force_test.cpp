// Both engines, compared with a test of every surface in long double.
#include "pt/geometry/primitives.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/tracer.h"
#include "tests/proof/meshes.h"

#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace pt::proof {
namespace {

// Rays against surfaces in long double, by plane and edges and by the plain quadratic formula. This
// is another method than the tasks', with 11 more bits, so its sure answers are right.

struct Exact {
  long double x = 0, y = 0, z = 0;

  Exact(long double x_, long double y_, long double z_) : x(x_), y(y_), z(z_) {}
  explicit Exact(Vec3 v) : x(v.x), y(v.y), z(v.z) {}
};

Exact operator-(Exact a, Exact b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

Exact operator+(Exact a, Exact b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

Exact operator*(long double s, Exact a) { return {s * a.x, s * a.y, s * a.z}; }

long double dot(Exact a, Exact b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Exact cross(Exact a, Exact b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

long double length(Exact a) { return std::sqrt(dot(a, a)); }

// The meeting of a ray and one surface: a miss, a hit at t, or so close to an edge, a silhouette or
// an end of the range, or at such a small angle, that either answer is right. Then t is where the
// hit would be.
struct Meeting {
  enum class Kind { miss, hit, either } kind = Kind::miss;
  long double t = 0;
  long double error = 0;  // of a t in double
};

// Relative to the size of the numbers, double arithmetic may err at this distance: 2^12 roundings.
constexpr long double kClose = 0x1p-41L;

Meeting in_range(Meeting m, const Ray& ray) {
  if (m.t < ray.t_min - m.error || m.t > ray.t_max + m.error) return {};
  if (m.t < ray.t_min + m.error || m.t > ray.t_max - m.error) m.kind = Meeting::Kind::either;
  return m;
}

// A triangle without a plane has no hit. `kClose` is relative to the distance of the farthest
// corner, because the subtracted numbers have this size.
Meeting meet(const Triangle& triangle, const Ray& ray) {
  const Exact o(ray.origin), d(ray.direction), p0(triangle.p0), p1(triangle.p1), p2(triangle.p2);
  const Exact normal = cross(p1 - p0, p2 - p0);
  const long double size = std::max({length(p1 - p0), length(p2 - p0), length(p2 - p1)});
  const long double reach = std::max({length(p0 - o), length(p1 - o), length(p2 - o)}) + size;
  // The triple product, which is the divisor of everything, relative to the lengths. Within a
  // rounding of zero there is no hit; up to some hundred roundings, the place is unknown.
  const long double product = std::abs(dot(normal, d)) / (size * size * length(d));
  if (!(product > 0x1p-53L)) return {};
  const Exact n = (1 / length(normal)) * normal;
  const long double cosine = dot(n, d) / length(d);
  if (product < 0x1p-45L) return {Meeting::Kind::either, 0, HUGE_VALL};
  const long double t = dot(n, p0 - o) / (cosine * length(d));
  const Exact at = o + t * d;
  // The distances of the point in the plane from the edges, negative outside.
  const auto inside = [&](Exact a, Exact b) {
    return dot(n, cross(b - a, at - a)) / length(b - a);
  };
  const long double edge = std::min({inside(p0, p1), inside(p1, p2), inside(p2, p0)});
  // An error across the ray becomes larger along the plane, by the factor 1 / cosine.
  const long double slack = kClose * reach / std::abs(cosine) * (size * size / length(normal));
  if (edge < -slack) return {};
  return in_range({edge > slack ? Meeting::Kind::hit : Meeting::Kind::either, t, slack / length(d)},
                  ray);
}

// Both roots, the nearer first.
std::vector<Meeting> meet(const Sphere& sphere, const Ray& ray) {
  const Exact d(ray.direction), to_center = Exact(sphere.center) - Exact(ray.origin);
  const long double speed = length(d), radius = sphere.radius;
  const long double along = dot(to_center, d) / speed;
  const Exact aside = to_center - (along / speed) * d;
  const long double reach = length(to_center) + radius;
  const long double gap = radius - length(aside);
  if (gap < -kClose * reach) return {};
  const bool graze = gap < kClose * reach;
  const long double half = std::sqrt(std::max(0.0L, radius * radius - dot(aside, aside)));
  // Near the silhouette, an error of the gap moves the ends of the chord by its square root.
  const long double error =
      graze ? 2 * std::sqrt(2 * radius * kClose * reach) : kClose * reach * (1 + radius / half);
  std::vector<Meeting> meetings;
  for (const long double t : {along - half, along + half}) {
    const Meeting m = in_range(
        {graze ? Meeting::Kind::either : Meeting::Kind::hit, t / speed, error / speed}, ray);
    if (m.kind != Meeting::Kind::miss) meetings.push_back(m);
  }
  return meetings;
}

// All meetings of a ray, each with its surface.
struct Meetings {
  std::vector<Meeting> list;
  std::vector<int> primitives;
  bool sure = false;                // there is at least one hit
  long double nearest = HUGE_VALL;  // the smallest t + error of the hits

  void add(int primitive, const Meeting& m) {
    if (m.kind == Meeting::Kind::miss) return;
    list.push_back(m);
    primitives.push_back(primitive);
    if (m.kind != Meeting::Kind::hit) return;
    sure = true;
    nearest = std::min(nearest, m.t + m.error);
  }

  // Returns whether only one answer is right.
  bool decided() const { return sure || list.empty(); }

  // Returns whether the hit is one of the meetings and no sure meeting is nearer.
  bool allow_closest(const std::optional<Hit>& hit) const {
    if (!hit) return !sure;
    bool found = false;
    for (std::size_t i = 0; i < list.size(); ++i) {
      found = found ||
              (hit->primitive == primitives[i] && std::abs(hit->t - list[i].t) <= list[i].error);
    }
    const long double slack = kClose * std::abs(static_cast<long double>(hit->t));
    return found && hit->t <= nearest + slack && is_finite(hit->n);
  }

  bool allow_occluded(bool occluded) const { return occluded ? !list.empty() : !sure; }
};

Meetings meet_all(const Primitives& primitives, const Ray& ray) {
  Meetings all;
  for (int i = 0; i < primitives.size(); ++i) {
    if (primitives.is_triangle(i)) {
      all.add(i, meet(primitives.triangle(i), ray));
    } else {
      for (const Meeting& m : meet(primitives.sphere(i), ray)) all.add(i, m);
    }
  }
  return all;
}

int any_of(const Primitives& primitives, Sampler& sampler) {
  return static_cast<int>(sampler.next_1d() * primitives.size());
}

// Rays of all kinds: between random points; at a point of a surface, so that most of them hit;
// between two surfaces; along an axis from a corner's coordinates, with zeros of both signs, so
// that they start in the planes of boxes; and with any length of the direction and any range.
Ray any_ray(const Primitives& primitives, int kind, Sampler& sampler) {
  const Vec3 target = point_of(primitives, any_of(primitives, sampler), sampler);
  switch (kind % 5) {
    case 0:
      return {in_cube(sampler, 2), in_cube(sampler), 0, kInfinity};
    case 1: {
      const Vec3 origin = in_cube(sampler, 3);
      return {origin, target - origin, 0, kInfinity};
    }
    case 2: {
      const Vec3 origin = point_of(primitives, any_of(primitives, sampler), sampler);
      return {origin, target - origin, 1e-3, 2};
    }
    case 3: {
      const int axis = static_cast<int>(sampler.next_1d() * 3);
      const double zero = sampler.next_1d() < 0.5 ? 0.0 : -0.0;
      Vec3 direction{zero, zero, zero}, origin = on_grid(sampler);
      direction[axis] = sampler.next_1d() < 0.5 ? -1 : 1;
      if (sampler.next_1d() < 0.5) direction[(axis + 1) % 3] = 0.5;
      if (sampler.next_1d() < 0.7) origin[(axis + 1) % 3] = target[(axis + 1) % 3];
      origin[axis] = -3 * direction[axis];
      return {origin, direction, 0, kInfinity};
    }
    default: {
      const Vec3 origin = in_cube(sampler, 3);
      const double stretch = std::pow(10, 6 * sampler.next_1d() - 3);
      const double from = sampler.next_1d() / stretch;
      return {origin, stretch * (target - origin), from, from + 1 / stretch};
    }
  }
}

Tracer tracer_of(int kind, const Primitives& primitives) {
  return kind == 0 ? Tracer(Engine::linear, primitives) : Tracer(Engine::task, primitives, kind);
}

// Engine 0 is linear; the others have leaves of 1 to 8 surfaces.
void expect_brute_force(const Mesh& mesh, int rays) {
  const Primitives& primitives = mesh.primitives;
  std::vector<Tracer> tracers;
  for (int kind = 0; kind <= 8; ++kind) tracers.push_back(tracer_of(kind, primitives));
  Sampler sampler(64);
  int decided = 0;
  for (int i = 0; i < rays; ++i) {
    const Ray ray = any_ray(primitives, i, sampler);
    const Meetings truth = meet_all(primitives, ray);
    decided += truth.decided() ? 1 : 0;
    for (int kind = 0; kind <= 8; ++kind) {
      const std::optional<Hit> hit = tracers[kind].closest(primitives, ray);
      const bool occluded = tracers[kind].occluded(primitives, ray);
      const std::string what =
          mesh.name + ", leaves of " + std::to_string(kind) + ", ray " + std::to_string(i);
      ASSERT_TRUE(truth.allow_closest(hit)) << what << ": t = " << (hit ? hit->t : -1)
                                            << ", primitive " << (hit ? hit->primitive : -1);
      ASSERT_TRUE(truth.allow_occluded(occluded)) << what;
      ASSERT_EQ(occluded, hit.has_value()) << what;
    }
  }
  // The oracle must decide most rays. (A flat grid of surfaces shares all its coordinates with the
  // rays along its axes, a fifth of all rays.)
  EXPECT_GT(decided, rays * 0.75) << mesh.name;
}

TEST(BruteForce, agrees_with_both_engines) {
  for (const Mesh& mesh : meshes()) expect_brute_force(mesh, 2000);
}

TEST(BruteForce, agrees_where_there_is_nothing) {
  const Primitives none;
  for (const Engine engine : {Engine::linear, Engine::task}) {
    const Tracer tracer(engine, none);
    EXPECT_FALSE(tracer.closest(none, {{}, {0, 0, 1}, 0, kInfinity}));
    EXPECT_FALSE(tracer.occluded(none, {{}, {0, 0, 1}, 0, kInfinity}));
  }
}

// A ray at a surface without area never hits it: there is neither t nor a normal.
TEST(BruteForce, never_meets_what_has_no_area) {
  const Primitives lines = without_area().primitives;
  Sampler sampler(65);
  for (int i = 0; i < 300000; ++i) {
    const int primitive = any_of(lines, sampler);
    const Vec3 target = point_of(lines, primitive, sampler);
    const Vec3 origin = i % 2 == 0 ? in_cube(sampler, 3) : on_grid(sampler);
    const Ray ray{origin, target - origin, 0, kInfinity};
    ASSERT_FALSE(hit_triangle(lines.triangle(primitive), ray)) << "triangle " << primitive;
  }
}

// A ray in the plane of a triangle misses it too, whatever the plane. Its ends are rounded by less
// than 16 roundings of the direction's length, unless this is too short.
TEST(BruteForce, never_meets_a_plane_it_runs_in) {
  Sampler sampler(66);
  for (int i = 0; i < 300000; ++i) {
    const Vec3 e1 = in_cube(sampler), e2 = in_cube(sampler);
    const double a = 4 * sampler.next_1d() - 2, b = 4 * sampler.next_1d() - 2;
    const Vec3 origin = a * e1 + b * e2;
    const Ray ray{origin, 0.3 * e1 + 0.3 * e2 - origin, 0, kInfinity};
    if (length(ray.direction) < 1.5) continue;
    ASSERT_FALSE(hit_triangle(any_triangle({}, e1, e2), ray)) << i;
  }
}

}  // namespace
}  // namespace pt::proof
