#pragma once

#include "pt/geometry/primitives.h"
#include "pt/sampling/directions.h"
#include "pt/sampling/sampler.h"

#include <cmath>
#include <vector>

// Meshes from formulas, for tests of the tracing engines and for the benchmark.

namespace pt {

inline double uniform(Sampler& sampler, double low, double high) {
  return low + (high - low) * sampler.next_1d();
}
inline Vec3 uniform_in_cube(Sampler& sampler) {
  const double x = uniform(sampler, -1, 1), y = uniform(sampler, -1, 1);
  return {x, y, uniform(sampler, -1, 1)};
}
inline Vec3 uniform_direction(Sampler& sampler) {
  const Vec3 up = uniform_hemisphere(sampler.next_2d());
  return sampler.next_1d() < 0.5 ? up : -up;
}

// A closed, star-shaped surface around the origin, of 4 rows^2 triangles that share their corners'
// exact coordinates. `bumps` = 0 makes it a sphere of radius 1, with smooth normals.
inline std::vector<Triangle> blob(int rows, double bumps = 0) {
  const int columns = 2 * rows;
  const auto corner = [&](int row, int column) {
    if (row == 0) return Vec3{0, 0, 1};
    if (row == rows) return Vec3{0, 0, -1};
    const double theta = kPi * row / rows, phi = 2 * kPi * (column % columns) / columns;
    const Vec3 d{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
    return (1 + bumps * std::sin(7 * d.x) * std::sin(9 * d.y) * std::sin(8 * d.z)) * d;
  };
  std::vector<Triangle> triangles;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Vec3 a = corner(row, column), b = corner(row + 1, column);
      const Vec3 c = corner(row + 1, column + 1), d = corner(row, column + 1);
      const Vec3 na = normalize(a), nb = normalize(b), nc = normalize(c), nd = normalize(d);
      if (row + 1 < rows) triangles.push_back({a, b, c, na, nb, nc});
      if (row > 0) triangles.push_back({a, c, d, na, nc, nd});
    }
  }
  return triangles;
}

// A soup of triangles: corners anywhere in the cube [-1, 1]^3, each triangle shrunk to `size`.
inline std::vector<Triangle> soup(int count, double size, std::uint64_t seed) {
  Sampler sampler(seed);
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    const Vec3 p = uniform_in_cube(sampler);
    const Vec3 a = uniform_in_cube(sampler), b = uniform_in_cube(sampler);
    triangles.push_back(flat_triangle(p, p + size * a, p + size * b));
  }
  return triangles;
}

// A flat grid in the plane z = 0, of 2 n^2 triangles over [-1, 1]^2.
inline std::vector<Triangle> grid(int n) {
  std::vector<Triangle> triangles;
  const auto corner = [&](int i, int j) { return Vec3{2.0 * i / n - 1, 2.0 * j / n - 1, 0}; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Vec3 a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1);
      triangles.push_back(flat_triangle(a, b, c));
      triangles.push_back(flat_triangle(a, c, corner(i, j + 1)));
    }
  }
  return triangles;
}

// Moves all corners p to scale p + shift.
inline void place(std::vector<Triangle>& triangles, double scale, Vec3 shift) {
  for (Triangle& t : triangles) {
    for (Vec3* p : {&t.p0, &t.p1, &t.p2}) *p = scale * *p + shift;
  }
}

}  // namespace pt
