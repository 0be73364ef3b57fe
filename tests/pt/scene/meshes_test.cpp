#include "scenes/meshes.h"

#include "pt/error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

namespace scenes {
namespace {

using pt::Vec3;
using Faces = std::span<const std::array<int, 3>>;

const std::set<std::string_view> kClosed{"sphere", "blob", "coil", "vase", "gems"};

// A vector with twice the area as its length.
Vec3 face_normal(const Mesh& mesh, const std::array<int, 3>& face) {
  const Vec3 p0 = mesh.points[face[0]];
  return cross(mesh.points[face[1]] - p0, mesh.points[face[2]] - p0);
}

// Six times the enclosed volume: positive if the faces point outwards.
double signed_volume(const Mesh& mesh, Faces faces) {
  double sum = 0;
  for (const auto& face : faces) sum += dot(mesh.points[face[0]], face_normal(mesh, face));
  return sum;
}

// The index of each point among the distinct points.
std::vector<int> joined(const std::vector<Vec3>& points) {
  std::map<std::tuple<double, double, double>, int> places;
  std::vector<int> indices;
  for (const Vec3& p : points) {
    indices.push_back(places.try_emplace({p.x, p.y, p.z}, places.size()).first->second);
  }
  return indices;
}

// Returns whether each edge occurs exactly once in each direction.
bool is_closed(const Mesh& mesh) {
  const std::vector<int> place = joined(mesh.points);
  std::set<std::pair<int, int>> edges;
  for (const auto& face : mesh.faces) {
    for (int i = 0; i < 3; ++i) {
      if (!edges.emplace(place[face[i]], place[face[(i + 1) % 3]]).second) return false;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [&](auto edge) {
    return edges.count({edge.second, edge.first}) == 1;
  });
}

// The mean of 1 - cos(angle between a face and its corner normals), by area.
double disagreement(const Mesh& mesh) {
  double sum = 0, area = 0;
  for (const auto& face : mesh.faces) {
    const Vec3 n = face_normal(mesh, face);
    for (int corner : face) sum += length(n) - dot(n, mesh.normals[corner]);
    area += 3 * length(n);
  }
  return sum / area;
}

TEST(Meshes, have_about_as_many_triangles_as_asked_for) {
  for (const Kind& kind : kinds()) {
    for (int n = 100; n < 3000; n += n / 50 + 1) {
      const int count = static_cast<int>(kind.make(n).faces.size());
      EXPECT_LE(count, n) << kind.name;
      EXPECT_GT(count, n - 3 * std::sqrt(n)) << kind.name;
    }
  }
  EXPECT_EQ(make_slivers(1234).faces.size(), 1234u);
}

TEST(Meshes, are_refused_where_they_cannot_be_made) {
  for (const Kind& kind : kinds()) {
    for (int n : {-1, 0, 99, 10'000'001}) EXPECT_THROW(kind.make(n), pt::Error) << kind.name;
  }
}

TEST(Meshes, are_sound_and_within_their_bounds) {
  for (const Kind& kind : kinds()) {
    for (int n : {100, 1000, 30000}) {
      const Mesh mesh = kind.make(n);
      ASSERT_EQ(mesh.points.size(), mesh.normals.size());
      for (const Vec3& p : mesh.points) EXPECT_LE(max_abs(p), 1.1) << kind.name;
      // Normalising rounds each component by a few 2^-53.
      for (const Vec3& normal : mesh.normals) EXPECT_NEAR(length(normal), 1, 1e-14) << kind.name;
      for (const auto& face : mesh.faces) {
        for (int corner : face) {
          ASSERT_GE(corner, 0);
          ASSERT_LT(corner, static_cast<int>(mesh.points.size()));
        }
        EXPECT_GT(length(face_normal(mesh, face)), 0) << kind.name << " " << n;
      }
    }
  }
}

TEST(Meshes, are_closed_where_they_say_so) {
  for (const Kind& kind : kinds()) {
    for (int n : {100, 1000, 30000}) {
      EXPECT_EQ(is_closed(kind.make(n)), kClosed.count(kind.name) == 1) << kind.name << " " << n;
    }
  }
}

TEST(Meshes, face_outwards) {
  for (const Kind& kind : kinds()) {
    for (int n : {1000, 30000}) {
      const Mesh mesh = kind.make(n);
      for (const auto& face : mesh.faces) {
        for (int corner : face) {
          ASSERT_GT(dot(face_normal(mesh, face), mesh.normals[corner]), 0) << kind.name << " " << n;
        }
      }
      if (kClosed.count(kind.name) == 0) continue;
      const std::size_t parts = kind.name == "gems" ? 3 : 1;
      const std::size_t size = mesh.faces.size() / parts;
      for (std::size_t part = 0; part < parts; ++part) {
        EXPECT_GT(signed_volume(mesh, Faces(mesh.faces).subspan(part * size, size)), 0)
            << kind.name << " " << n;
      }
    }
  }
  for (const Vec3& normal : make_terrain(1000).normals) EXPECT_GT(normal.y, 0);
}

// The angle between a face and the surface is proportional to the face's size, and 1 - cos to the
// angle squared: four times the triangles give a quarter. Wrong normals stay wrong.
TEST(Meshes, have_the_normals_of_the_surface_that_they_approach) {
  for (const Kind& kind : kinds()) {
    if (kind.name == "gems" || kind.name == "slivers") continue;
    const double coarse = disagreement(kind.make(20000));
    const double fine = disagreement(kind.make(80000));
    EXPECT_GT(coarse / fine, 3) << kind.name;
    EXPECT_LT(coarse / fine, 5) << kind.name;
  }
}

// The tube's volume is its cross section times the length of its middle line (Pappus), which is
// summed over a fine polygon here. The error of the mesh's polygons is proportional to their angles
// squared: four times the triangles give a quarter of the error.
TEST(Coil, has_the_volume_of_its_tube) {
  constexpr int kSteps = 1'000'000;
  double length_of_line = 0;
  Vec3 before{.92, 0, 0};
  for (int i = 1; i <= kSteps; ++i) {
    const double theta = 2 * pt::kPi * i / kSteps;
    const double r = .7 + .22 * std::cos(14 * theta);
    const Vec3 p{r * std::cos(theta), r * std::sin(theta), .22 * std::sin(14 * theta)};
    length_of_line += length(p - before);
    before = p;
  }
  const double expected = pt::kPi * .06 * .06 * length_of_line;
  const auto missing = [&](int triangles) {
    const Mesh mesh = make_coil(triangles);
    return expected - signed_volume(mesh, mesh.faces) / 6;
  };
  EXPECT_GT(missing(80000), 0);
  EXPECT_GT(missing(20000) / missing(80000), 3);
  EXPECT_LT(missing(20000) / missing(80000), 5);
}

TEST(Meshes, become_triangles_of_the_renderer) {
  const Mesh mesh = make_vase(1000);
  const pt::Primitives primitives = to_primitives(mesh);
  ASSERT_EQ(primitives.triangles.size(), mesh.faces.size());
  EXPECT_TRUE(primitives.spheres.empty());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    EXPECT_EQ(primitives.triangles[i].p1, mesh.points[mesh.faces[i][1]]);
    EXPECT_EQ(primitives.triangles[i].n2, mesh.normals[mesh.faces[i][2]]);
    EXPECT_EQ(geometric_normal(primitives.triangles[i]), face_normal(mesh, mesh.faces[i]));
  }
}

}  // namespace
}  // namespace scenes
