#pragma once

#include "pt/geometry/primitives.h"
#include "pt/sampling/directions.h"
#include "pt/sampling/sampler.h"

#include <string>
#include <vector>

// Surfaces that are hard to trace.

namespace pt::proof {

struct Mesh {
  std::string name;
  Primitives primitives;
};

inline Vec3 in_cube(Sampler& sampler, double half = 1) {
  const double x = sampler.next_1d(), y = sampler.next_1d(), z = sampler.next_1d();
  return half * Vec3{2 * x - 1, 2 * y - 1, 2 * z - 1};
}

// Points on a grid of eighths, so that many coordinates coincide and small sums are exact.
inline Vec3 on_grid(Sampler& sampler) {
  const Vec3 p = in_cube(sampler, 8);
  return {std::round(p.x) / 8, std::round(p.y) / 8, std::round(p.z) / 8};
}

// A triangle without area gets some normal.
inline Triangle any_triangle(Vec3 a, Vec3 b, Vec3 c) {
  Triangle triangle = flat_triangle(a, b, c);
  if (!is_finite(triangle.n0)) triangle.n0 = triangle.n1 = triangle.n2 = {0, 0, 1};
  return triangle;
}

inline Mesh random_soup(int triangles, int spheres, double size) {
  Sampler sampler(61);
  Mesh mesh{"soup", {}};
  for (int i = 0; i < triangles; ++i) {
    const Vec3 p = in_cube(sampler);
    mesh.primitives.triangles.push_back(
        any_triangle(p, p + in_cube(sampler, size), p + in_cube(sampler, size)));
  }
  for (int i = 0; i < spheres; ++i) {
    mesh.primitives.spheres.push_back({in_cube(sampler), 0.01 + size * sampler.next_1d()});
  }
  return mesh;
}

// A height field over a grid: closed, with shared edges, and flat if the height is 0.
inline Mesh terrain(double height) {
  Mesh mesh{height > 0 ? "terrain" : "flat", {}};
  const int n = 8;
  const auto at = [&](int i, int j) {
    return Vec3{i / 4.0 - 1, j / 4.0 - 1, height * ((i * 7 + j * 3) % 5)};
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      mesh.primitives.triangles.push_back(any_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1)));
      mesh.primitives.triangles.push_back(any_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1)));
    }
  }
  return mesh;
}

inline Mesh duplicates() {
  Sampler sampler(62);
  Mesh mesh{"duplicates", {}};
  for (int i = 0; i < 5; ++i) {
    const Triangle t = any_triangle(in_cube(sampler), in_cube(sampler), in_cube(sampler));
    for (int copy = 0; copy < 9; ++copy) mesh.primitives.triangles.push_back(t);
    for (int copy = 0; copy < 5; ++copy) mesh.primitives.spheres.push_back({t.p0, 0.2});
  }
  return mesh;
}

// Boxes of every size around one centre, exact to the last bit.
inline Mesh one_centroid() {
  Mesh mesh{"one centroid", {}};
  for (int i = 1; i <= 40; ++i) {
    const double s = i / 64.0;
    mesh.primitives.triangles.push_back(any_triangle({-s, -s, -s}, {s, s, s}, {s, -s, 0}));
    if (i % 4 == 0) mesh.primitives.spheres.push_back({{0, 0, 0}, s});
  }
  return mesh;
}

// Triangles without area: points and lines in every position; some lines are exactly straight.
inline Mesh without_area() {
  Sampler sampler(63);
  Mesh mesh{"without area", {}};
  for (int i = 0; i < 40; ++i) {
    const Vec3 a = on_grid(sampler), b = on_grid(sampler);
    const Vec3 c = in_cube(sampler), d = in_cube(sampler);
    for (const Triangle& t : {any_triangle(a, a, a), any_triangle(a, b, b), any_triangle(a, b, a),
                              any_triangle(a, 0.5 * (a + b), b), any_triangle(c, c, d),
                              any_triangle(a, 2 * a - b, b)}) {
      mesh.primitives.triangles.push_back(t);
    }
  }
  return mesh;
}

inline Mesh mixed() {
  Mesh mesh = random_soup(60, 6, 0.3);
  mesh.name = "mixed";
  for (const Mesh& other : {without_area(), duplicates(), terrain(0)}) {
    const auto& t = other.primitives.triangles;
    mesh.primitives.triangles.insert(mesh.primitives.triangles.end(), t.begin(), t.end());
  }
  return mesh;
}

inline std::vector<Mesh> meshes() {
  return {random_soup(150, 0, 0.2),
          random_soup(30, 10, 0.5),
          random_soup(0, 20, 0.3),
          terrain(0.1),
          terrain(0),
          duplicates(),
          one_centroid(),
          without_area(),
          mixed()};
}

// A point of the surface.
inline Vec3 point_of(const Primitives& primitives, int i, Sampler& sampler) {
  const Vec2 xi = sampler.next_2d();
  if (!primitives.is_triangle(i)) {
    const Sphere& s = primitives.sphere(i);
    return s.center + s.radius * uniform_hemisphere(xi);
  }
  const Triangle& t = primitives.triangle(i);
  const double r = std::sqrt(xi.x);
  return (1 - r) * t.p0 + r * (1 - xi.y) * t.p1 + r * xi.y * t.p2;
}

}  // namespace pt::proof
