#include "scenes/mesh_grid.h"
#include "scenes/meshes.h"

#include <array>
#include <cmath>

namespace scenes {

using pt::Vec2;
using pt::Vec3;

namespace {

// Half the profile of a vase, (distance from the axis, height): from the middle of the foot, up the
// outside, over the lip and down the inside. The control points of a uniform cubic B-spline, which
// does not pass through them.
constexpr std::array<Vec2, 17> kVase{{{0, 0},
                                      {.40, 0},
                                      {.44, .05},
                                      {.70, .40},
                                      {.82, .85},
                                      {.50, 1.35},
                                      {.30, 1.65},
                                      {.44, 1.95},
                                      {.56, 2.05},
                                      {.48, 2.06},
                                      {.38, 1.95},
                                      {.23, 1.65},
                                      {.42, 1.35},
                                      {.73, .85},
                                      {.60, .42},
                                      {.28, .14},
                                      {0, .14}}};

// Beyond its ends the profile continues mirrored, so that it crosses the axis at a right angle.
Vec2 control_point(int i) {
  const int last = static_cast<int>(kVase.size()) - 1;
  if (i < 0) return {-kVase[-i].x, kVase[-i].y};
  if (i > last) return {-kVase[2 * last - i].x, kVase[2 * last - i].y};
  return kVase[i];
}

struct ProfilePoint {
  Vec2 at;
  Vec2 tangent;
};

// The B-spline and its derivative at s in [0, 16].
ProfilePoint profile(double s) {
  const int segment = std::min(static_cast<int>(s), static_cast<int>(kVase.size()) - 2);
  const double t = s - segment;
  const std::array<double, 4> weight{(1 - t) * (1 - t) * (1 - t) / 6,
                                     (4 - 6 * t * t + 3 * t * t * t) / 6,
                                     (1 + 3 * t + 3 * t * t - 3 * t * t * t) / 6, t * t * t / 6};
  const std::array<double, 4> slope{-(1 - t) * (1 - t) / 2, (-4 * t + 3 * t * t) / 2,
                                    (1 + 2 * t - 3 * t * t) / 2, t * t / 2};
  ProfilePoint point;
  for (int k = 0; k < 4; ++k) {
    const Vec2 control = control_point(segment - 1 + k);
    point.at.x += weight[k] * control.x;
    point.at.y += weight[k] * control.y;
    point.tangent.x += slope[k] * control.x;
    point.tangent.y += slope[k] * control.y;
  }
  return point;
}

}  // namespace

Mesh make_coil(int triangles) {
  check_count(triangles);
  constexpr double kTurns = 14, kRing = 0.7, kTurn = 0.22, kTube = 0.06;
  const int around = std::max(4, static_cast<int>(std::sqrt(triangles / 32.0)));
  const int along = triangles / (2 * around);
  Mesh mesh;
  for (int i = 0; i < along; ++i) {
    const double theta = 2 * pt::kPi * i / along;
    const double turn = kTurns * theta;
    const Vec3 out{std::cos(theta), std::sin(theta), 0};  // from the middle of the ring
    const Vec3 on{-out.y, out.x, 0};                      // on along the ring
    const double distance = kRing + kTurn * std::cos(turn);
    const Vec3 center = distance * out + Vec3{0, 0, kTurn * std::sin(turn)};
    const Vec3 tangent = normalize(distance * on - (kTurns * kTurn * std::sin(turn)) * out +
                                   Vec3{0, 0, kTurns * kTurn * std::cos(turn)});
    const Vec3 normal = std::cos(turn) * out + Vec3{0, 0, std::sin(turn)};
    const Vec3 binormal = cross(tangent, normal);
    for (int j = 0; j < around; ++j) {
      const double alpha = 2 * pt::kPi * j / around;
      const Vec3 n = std::cos(alpha) * normal + std::sin(alpha) * binormal;
      mesh.points.push_back(center + kTube * n);
      mesh.normals.push_back(n);
    }
  }
  mesh.faces = grid_faces(along, around, true, true);
  return mesh;
}

Mesh make_vase(int triangles) {
  check_count(triangles);
  const int rings = static_cast<int>(std::sqrt(triangles / 2.0));
  const int around = triangles / (2 * rings);
  Mesh mesh;
  for (int i = 1; i <= rings; ++i) {
    const ProfilePoint point = profile((kVase.size() - 1.0) * i / (rings + 1));
    const double size = std::hypot(point.tangent.x, point.tangent.y);
    for (int j = 0; j < around; ++j) {
      const double phi = 2 * pt::kPi * j / around;
      const Vec3 out{std::cos(phi), 0, -std::sin(phi)};
      mesh.points.push_back(point.at.x * out + Vec3{0, point.at.y - 1, 0});
      mesh.normals.push_back((point.tangent.y * out - Vec3{0, point.tangent.x, 0}) / size);
    }
  }
  mesh.faces = grid_faces(rings, around, false, true);
  const int first = static_cast<int>(mesh.points.size());
  const int top = (rings - 1) * around;
  for (int j = 0; j < around; ++j) {
    const int next = (j + 1) % around;
    mesh.faces.push_back({first, next, j});
    mesh.faces.push_back({top + j, top + next, first + 1});
  }
  // The two ends: below the foot, and the bottom of the inside.
  mesh.points.push_back({0, profile(0).at.y - 1, 0});
  mesh.normals.push_back({0, -1, 0});
  mesh.points.push_back({0, profile(kVase.size() - 1.0).at.y - 1, 0});
  mesh.normals.push_back({0, 1, 0});
  return mesh;
}

Mesh make_terrain(int triangles) {
  check_count(triangles);
  struct Wave {
    double x, z, height;
  };
  constexpr std::array<Wave, 6> kWaves{
      {{2, 1, .15}, {-1, 3, .12}, {5, -4, .05}, {3, 7, .04}, {-13, 9, .012}, {11, 17, .009}}};
  const int rows = static_cast<int>(std::sqrt(triangles / 2.0)) + 1;
  const int columns = triangles / (2 * (rows - 1)) + 1;
  Mesh mesh;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      Vec3 p{2.0 * i / (rows - 1) - 1, 0, 2.0 * j / (columns - 1) - 1};
      Vec3 n{0, 1, 0};
      for (const Wave& wave : kWaves) {
        const double phase = wave.x * p.x + wave.z * p.z + 30 * wave.height;
        p.y += wave.height * std::sin(phase);
        n -= (wave.height * std::cos(phase)) * Vec3{wave.x, 0, wave.z};
      }
      mesh.points.push_back(p);
      mesh.normals.push_back(normalize(n));
    }
  }
  mesh.faces = grid_faces(rows, columns, false, false);
  return mesh;
}

}  // namespace scenes
