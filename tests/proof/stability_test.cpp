#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "tests/proof/closed_forms.h"
#include "tests/proof/meshes.h"
#include "tests/proof/scenes.h"
#include "tests/proof/statistics.h"

// Sizes from a millionth to a million, near the world's origin and far from it. Methods that are
// right on paper fail here; each test names some.

namespace pt::proof {
namespace {

constexpr double kSizes[] = {1e-6, 1, 1e6};
// Distances from the origin, relative to the size.
constexpr double kShifts[] = {0, 1e2, 1e4, 1e6};

Vec3 any_direction(Sampler& sampler) {
  const Vec3 w = uniform_hemisphere(sampler.next_2d());
  return sampler.next_1d() < 0.5 ? w : -w;
}

// ---- intersections

// The textbook's discriminant is wrong by more than a thousandth from 2e6 radii on.
TEST(Stability, far_spheres_keep_their_shape) {
  Sampler sampler(81);
  for (const double size : kSizes) {
    for (const double distance : {1.5, 1e3, 1e5, 1e7}) {
      const Sphere sphere{size * in_cube(sampler), size};
      for (int i = 0; i < 2000; ++i) {
        // Rays at a point of the near half, far enough from the silhouette to be a sure hit.
        const Vec3 away = any_direction(sampler);
        Vec3 n = any_direction(sampler);
        if (dot(n, away) < 0) n = -n;
        if (dot(n, away) < 0.1 + 1 / distance) continue;
        const Vec3 origin = sphere.center + size * distance * away;
        const Vec3 direction = normalize(sphere.center + size * n - origin);
        const auto hit = hit_sphere(sphere, {origin, direction, 0, kInfinity});
        ASSERT_TRUE(hit) << distance;
        const double error = length(origin + hit->t * direction - sphere.center) / size - 1;
        ASSERT_LE(std::abs(error), 1e-6) << distance;
        ASSERT_LE(length(hit->n - n), 1e-6) << distance;
      }
    }
  }
}

// An absolute epsilon for the determinant makes small triangles disappear.
TEST(Stability, triangles_of_every_size_are_hit_where_aimed) {
  Sampler sampler(82);
  for (const double size : kSizes) {
    for (int i = 0; i < 20000; ++i) {
      const Triangle t =
          any_triangle(size * in_cube(sampler), size * in_cube(sampler), size * in_cube(sampler));
      const Vec2 xi = sampler.next_2d();
      const double b1 = 0.01 + 0.48 * xi.x, b2 = 0.01 + 0.48 * xi.y;
      const Vec3 target = (1 - b1 - b2) * t.p0 + b1 * t.p1 + b2 * t.p2;
      const Vec3 origin = target + 3 * size * any_direction(sampler);
      const Vec3 direction = normalize(target - origin);
      // Triangles that are well shaped and not seen from the side.
      const double area = length(geometric_normal(t)) / (size * size);
      if (area < 0.1 || std::abs(dot(direction, t.n0)) < 0.1) continue;
      const auto hit = hit_triangle(t, {origin, direction, 0, kInfinity});
      ASSERT_TRUE(hit) << size;
      ASSERT_NEAR(hit->t / (3 * size), 1, 1e-9);
    }
  }
}

// ---- leaving a surface

Vec3 shift(double size, double shifts, Sampler& sampler) {
  return size * shifts * normalize(in_cube(sampler));
}

// From a hit point, at any angle, no ray in any direction on either side meets the triangle's own
// plane. (Without an offset, 36 to 52 % do; with an offset of 1e-11, some from scale 100 on.)
TEST(Stability, triangles_do_not_meet_themselves) {
  Sampler sampler(83);
  for (const double size : kSizes) {
    for (const double shifts : kShifts) {
      int self_hits = 0, points = 0;
      for (int i = 0; i < 3000; ++i) {
        const Vec3 at = shift(size, shifts, sampler);
        const auto corner = [&] { return at + size * in_cube(sampler); };
        SceneBuilder builder;
        builder.triangle(corner(), corner(), corner(), builder.material(gray(0.5)));
        const Scene scene = builder.finish(Engine::linear);
        const Vec3 target = point_of(scene.primitives, 0, sampler);
        const Vec3 eye = target + size * any_direction(sampler);
        const Ray ray{eye, normalize(target - eye), 0, kInfinity};
        const auto hit = scene.closest(ray);
        if (!hit) continue;  // on an edge or from the side
        ++points;
        const SurfacePoint point = surface_point(scene, ray, *hit);
        for (int j = 0; j < 20; ++j) {
          // A third of the rays graze the surface.
          Vec3 w = any_direction(sampler);
          const Vec3 n = point.geometric_normal;
          if (j % 3 == 0) w = normalize(cross(n, w) + 1e-9 * w);
          self_hits += scene.occluded(spawn_ray(point, w)) ? 1 : 0;
        }
      }
      EXPECT_GT(points, 2500);
      EXPECT_EQ(self_hits, 0) << "size " << size << ", " << shifts << " sizes away";
    }
  }
}

// A ray that leaves a sphere outwards never returns; inwards, its next hit is the far side.
TEST(Stability, spheres_do_not_meet_themselves) {
  Sampler sampler(84);
  for (const double size : kSizes) {
    for (const double shifts : kShifts) {
      int self_hits = 0;
      for (int i = 0; i < 3000; ++i) {
        const Vec3 center = shift(size, shifts, sampler);
        SceneBuilder builder;
        builder.sphere(center, size, builder.material(gray(0.5)));
        const Scene scene = builder.finish(Engine::linear);
        const Vec3 eye = center + 3 * size * any_direction(sampler);
        const SurfacePoint point =
            point_seen(scene, eye, center + 0.9 * size * in_cube(sampler, 0.5));
        for (int j = 0; j < 20; ++j) {
          const Vec3 w = any_direction(sampler);
          const double cosine = dot(point.geometric_normal, w);
          const auto hit = scene.closest(spawn_ray(point, w));
          // Chords shorter than the effect of the offset are not judged.
          if (cosine < 0 && cosine > -1e-2) continue;
          const bool own = cosine > 0 ? hit.has_value() : hit && hit->t < -size * cosine;
          self_hits += own ? 1 : 0;
        }
      }
      EXPECT_EQ(self_hits, 0) << "size " << size << ", " << shifts << " sizes away";
    }
  }
}

// A point's error grows with the length of the ray to it. Even so, on a small surface seen from far
// away no direction on the ray's side meets the surface again. (With an offset that knows only the
// surface's size, not the ray's origin or length, 16 to 50 % do.) A wall of two triangles is one
// plane, so a ray that leaves one of them may meet the other.
TEST(Stability, small_surfaces_seen_from_far_away_do_not_meet_themselves) {
  Sampler sampler(90);
  for (const double size : kSizes) {
    for (const double distance : {1e2, 1e4, 1e6}) {
      int self_hits = 0;
      for (int i = 0; i < 2000; ++i) {
        SceneBuilder builder;
        const int material = builder.material(gray(0.5));
        const Vec3 a = size * in_cube(sampler), b = size * in_cube(sampler);
        const Vec3 c = size * in_cube(sampler);
        if (i % 2 == 0) {
          builder.sphere(a, size, material);
        } else {
          builder.triangle(a, b, c, material);
          builder.triangle(c, b, b + c - a, material);
        }
        const Scene scene = builder.finish(Engine::linear);
        const Vec3 target = i % 2 == 0 ? a + 0.9 * size * in_cube(sampler, 0.5)
                                       : point_of(scene.primitives, 0, sampler);
        const Vec3 eye = target + distance * size * any_direction(sampler);
        const Ray ray{eye, normalize(target - eye), 0, kInfinity};
        const auto hit = scene.closest(ray);
        if (!hit) continue;
        const SurfacePoint point = surface_point(scene, ray, *hit);
        for (int j = 0; j < 20; ++j) {
          const Vec3 w = any_direction(sampler);
          const Vec3 n = point.geometric_normal;
          const Vec3 away = dot(n, point.wo) * dot(n, w) < 0 ? w - 2 * dot(n, w) * n : w;
          self_hits += scene.occluded(spawn_ray(point, away)) ? 1 : 0;
        }
      }
      EXPECT_EQ(self_hits, 0) << "size " << size << ", seen from " << distance << " sizes away";
    }
  }
}

// A light that is a surface of the scene does not hide itself, at any size and anywhere. A sheet
// just in front of it hides it, and a sheet just behind it does not.
void expect_visible(const SceneBuilder& builder, const Light& light, Vec3 eye, Vec3 target,
                    bool visible, const std::string& what) {
  for (const Engine engine : kEngines) {
    const Scene scene = builder.finish(engine);
    const SurfacePoint point = point_seen(scene, eye, target);
    Sampler sampler(85);
    int wrong = 0;
    for (int i = 0; i < 3000; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      if (is_black(sample.radiance) || !(dot(sample.wi, point.n) > 0)) continue;
      const Ray ray = shadow_ray(point, sample.wi, sample.distance);
      wrong += scene.occluded(ray) == visible ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0) << what;
  }
}

TEST(Stability, rectangles_do_not_hide_themselves) {
  Sampler sampler(86);
  for (const double size : kSizes) {
    for (const double shifts : kShifts) {
      for (const double distance : {0.05, 1.0, 20.0}) {
        const Place place{askew().frame, shift(size, shifts, sampler)};
        const auto at = [&](Vec3 local) { return place.point(size * local); };
        const auto along = [&](Vec3 local) { return place.direction(size * local); };
        for (const double sheet : {0.0, 0.99, 1.01}) {
          SceneBuilder builder;
          const int diffuse = builder.material(gray(0.5));
          builder.quad(at({-1, -0.7, 0}), along({2, 0, 0}), along({0, 2, 0}), diffuse);
          const Vec3 u = along({0.3, 1, 0.02}), v = along({1, -0.1, 0.01});
          const Vec3 center = at({0.2, 0.1, distance});
          builder.quad(center - 0.5 * u - 0.5 * v, u, v, diffuse);
          if (sheet > 0) {
            const Vec3 middle = at({0.2, 0.1, distance + (sheet - 1) * 2});
            builder.quad(middle - u - v, 2 * u, 2 * v, diffuse);
          }
          const Light light = RectangleLight{center, u, v, normalize(cross(u, v)), gray(1)};
          expect_visible(
              builder, light, at({0.013, 0.01, 0.02}), at({0.013, 0.02, 0}), sheet != 0.99,
              "size " + std::to_string(size) + ", " + std::to_string(shifts) + " sizes away, at " +
                  std::to_string(distance) + ", sheet " + std::to_string(sheet));
        }
      }
    }
  }
}

TEST(Stability, spheres_of_light_do_not_hide_themselves) {
  Sampler sampler(87);
  for (const double size : kSizes) {
    for (const double shifts : kShifts) {
      for (const double distance : {1.1, 3.0, 100.0}) {
        const Place place{askew().frame, shift(size, shifts, sampler)};
        const Vec3 center = place.point({0, 0, size * distance});
        SceneBuilder builder;
        const int diffuse = builder.material(gray(0.5));
        builder.quad(place.point({-size, -0.7 * size, 0}), place.direction({2 * size, 0, 0}),
                     place.direction({0, 2 * size, 0}), diffuse);
        builder.sphere(center, size, diffuse);
        expect_visible(builder, SphereLight{center, size, gray(1)},
                       place.point(size * Vec3{0.013, 0.01, 0.02}),
                       place.point(size * Vec3{0.013, 0.02, 0}), true,
                       "size " + std::to_string(size) + ", " + std::to_string(shifts) +
                           " sizes away, at " + std::to_string(distance));
      }
    }
  }
}

}  // namespace
}  // namespace pt::proof
