#include "pt/math/vec3.h"
#include "scenes/mesh_grid.h"
#include "scenes/meshes.h"

#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace scenes {

using pt::Vec3;

namespace {

// A box of cells[0] x cells[1] x cells[2] little cubes. Its sides have these numbers of squares.
struct CubeGrid {
  std::array<int, 3> cells;

  int triangles() const {
    return 4 * (cells[0] * cells[1] + cells[1] * cells[2] + cells[2] * cells[0]);
  }
};

// The finest grid within the count. Its three numbers differ by at most one.
CubeGrid cube_grid(int triangles) {
  const int n = static_cast<int>(std::sqrt(triangles / 12.0));
  CubeGrid grid{{n, n, n}};
  for (int axis = 0; axis < 3; ++axis) {
    CubeGrid finer = grid;
    ++finer.cells[axis];
    if (finer.triangles() <= triangles) grid = finer;
  }
  return grid;
}

// The coordinate of line i of n on the cube [-1, 1]^3. The tangent makes the angles at the centre equal.
double line(int i, int n) {
  if (i == 0 || i == n) return i == 0 ? -1 : 1;
  return std::tan(pt::kPi / 4 * (2.0 * i / n - 1));
}

// Joins the points that the sides of the cube share.
class CubeMesh {
 public:
  explicit CubeMesh(const CubeGrid& grid) : cells_(grid.cells) {
    mesh_.faces.reserve(grid.triangles());
    mesh_.points.reserve(grid.triangles() / 2 + 2);
    indices_.reserve(grid.triangles() / 2 + 2);
    for (int axis = 0; axis < 3; ++axis) {
      add_side(axis, 0);
      add_side(axis, cells_[axis]);
    }
  }

  Mesh take() { return std::move(mesh_); }

 private:
  void add_side(int axis, int level) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (int i = 0; i < cells_[u]; ++i) {
      for (int j = 0; j < cells_[v]; ++j) {
        std::array<int, 3> at{};
        const auto corner = [&](int du, int dv) {
          at[axis] = level;
          at[u] = i + du;
          at[v] = j + dv;
          return index(at);
        };
        const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
        add_square(a, level == 0 ? d : b, c, level == 0 ? b : d);
      }
    }
  }

  void add_square(int a, int b, int c, int d) {
    mesh_.faces.push_back({a, b, c});
    mesh_.faces.push_back({a, c, d});
  }

  int index(const std::array<int, 3>& at) {
    const std::int64_t key =
        (static_cast<std::int64_t>(at[0]) * (cells_[1] + 1) + at[1]) * (cells_[2] + 1) + at[2];
    const auto [found, is_new] = indices_.try_emplace(key, static_cast<int>(mesh_.points.size()));
    if (is_new) {
      mesh_.points.push_back(
          pt::normalize({line(at[0], cells_[0]), line(at[1], cells_[1]), line(at[2], cells_[2])}));
    }
    return found->second;
  }

  std::array<int, 3> cells_;
  Mesh mesh_;
  std::unordered_map<std::int64_t, int> indices_;
};

// Adds height exp(sharpness (cos(angle to the direction) - 1)) to a radius.
struct Bump {
  Vec3 direction;
  double height = 0;
  double sharpness = 0;
};

// `count` bumps spread evenly over the sphere on a spiral of golden angles.
std::vector<Bump> bumps(int count, double height, double sharpness) {
  const double golden_angle = pt::kPi * (3 - std::sqrt(5.0));
  std::vector<Bump> all;
  for (int i = 0; i < count; ++i) {
    const double y = 1 - (2 * i + 1.0) / count;
    const double r = std::sqrt(1 - y * y);
    const double phi = golden_angle * i + 0.4 * height * count;
    // Every third bump is a dent of half the depth.
    const double signed_height = i % 3 == 2 ? -0.5 * height : height;
    all.push_back({{r * std::cos(phi), y, r * std::sin(phi)}, signed_height, sharpness});
  }
  return all;
}

}  // namespace

Mesh make_sphere(int triangles) {
  check_count(triangles);
  Mesh mesh = CubeMesh(cube_grid(triangles)).take();
  mesh.normals = mesh.points;
  return mesh;
}

Mesh make_blob(int triangles) {
  std::vector<Bump> all = bumps(5, 0.4, 5);
  const std::vector<Bump> small = bumps(40, 0.12, 60);
  all.insert(all.end(), small.begin(), small.end());

  Mesh mesh = make_sphere(triangles);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec3 d = mesh.points[i];
    double radius = 0.65;
    Vec3 slope;  // of the radius, along the unit sphere
    for (const Bump& bump : all) {
      const double cosine = dot(bump.direction, d);
      const double value = bump.height * std::exp(bump.sharpness * (cosine - 1));
      radius += value;
      slope += (bump.sharpness * value) * (bump.direction - cosine * d);
    }
    mesh.points[i] = radius * d;
    mesh.normals[i] = normalize(d - slope / radius);
  }
  return mesh;
}

}  // namespace scenes
