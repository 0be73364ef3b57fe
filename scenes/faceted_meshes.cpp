#include "pt/math/frame.h"
#include "pt/sampling/sampler.h"
#include "scenes/mesh_grid.h"
#include "scenes/meshes.h"

#include <cmath>

namespace scenes {

using pt::Vec3;

namespace {

// Points on a circle around the y axis; `start` is in steps.
std::vector<Vec3> ring(int sides, double radius, double y, double start) {
  std::vector<Vec3> points;
  for (int i = 0; i < sides; ++i) {
    const double phi = 2 * pt::kPi * (i + start) / sides;
    points.push_back({radius * std::cos(phi), y, -radius * std::sin(phi)});
  }
  return points;
}

// One stone, table up, with 6 sides - 2 facets between three rings and the point below.
Mesh cut_stone(int sides) {
  const std::vector<Vec3> table = ring(sides, .55, .42, 0);
  const std::vector<Vec3> girdle = ring(sides, 1, .1, .5);
  const std::vector<Vec3> pavilion = ring(sides, .6, -.38, 1);
  const Vec3 tip{0, -.8, 0};
  Mesh stone;
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    add_facet(stone, pavilion[next], pavilion[i], tip);
    add_facet(stone, pavilion[i], pavilion[next], girdle[next]);
    add_facet(stone, girdle[i], pavilion[i], girdle[next]);
    add_facet(stone, girdle[i], girdle[next], table[next]);
    add_facet(stone, table[i], girdle[i], table[next]);
  }
  for (int i = 1; i + 1 < sides; ++i) add_facet(stone, table[0], table[i], table[i + 1]);
  return stone;
}

// Lays the stone on its first facet, turns it around the y axis and puts it at (x, z).
void add_lying(Mesh& gems, const Mesh& stone, double size, double turn, double x, double z) {
  const pt::Frame down = pt::frame_from_normal(stone.normals[0]);
  const double c = std::cos(turn), s = std::sin(turn);
  const auto turned = [&](Vec3 v) {
    const Vec3 local = down.to_local(v);
    const Vec3 lying{local.x, -local.z, local.y};
    return Vec3{c * lying.x + s * lying.z, lying.y, c * lying.z - s * lying.x};
  };
  const double ground = turned(stone.points[0]).y;
  const int first = static_cast<int>(gems.points.size());
  for (std::size_t i = 0; i < stone.points.size(); ++i) {
    gems.points.push_back(size * (turned(stone.points[i]) - Vec3{0, ground, 0}) + Vec3{x, 0, z});
    gems.normals.push_back(turned(stone.normals[i]));
  }
  for (const auto& [a, b, d] : stone.faces) {
    gems.faces.push_back({first + a, first + b, first + d});
  }
}

}  // namespace

Mesh make_gems(int triangles) {
  check_count(triangles);
  const Mesh stone = cut_stone((triangles / 3 + 2) / 6);
  Mesh gems;
  add_lying(gems, stone, .5, 0.3, -.45, -.35);
  add_lying(gems, stone, .4, 2.6, .5, -.1);
  add_lying(gems, stone, .3, 4.4, -.1, .65);
  return gems;
}

Mesh make_slivers(int triangles) {
  check_count(triangles);
  pt::Sampler sampler(1);
  Mesh mesh;
  mesh.points.reserve(3 * static_cast<std::size_t>(triangles));
  mesh.normals.reserve(3 * static_cast<std::size_t>(triangles));
  for (int i = 0; i < triangles; ++i) {
    const pt::Vec2 xy = sampler.next_2d();
    const Vec3 middle{1.4 * xy.x - .7, 1.4 * xy.y - .7, 1.4 * sampler.next_1d() - .7};
    const double z = 2 * sampler.next_1d() - 1;
    const double phi = 2 * pt::kPi * sampler.next_1d();
    const double r = std::sqrt(1 - z * z);
    const pt::Frame frame = pt::frame_from_normal({r * std::cos(phi), r * std::sin(phi), z});
    add_facet(mesh, middle - .4 * frame.z, middle + .4 * frame.z, middle + .005 * frame.x);
  }
  return mesh;
}

}  // namespace scenes
