// against_assimp FILE.dae: reads a file with our loader and with assimp 5, and prints "<kind><tab><how
// much>" for each difference, or "same". Who is right is in docs/scenes.md.
#include "pt/error.h"
#include "pt/geometry/box.h"
#include "pt/scene/load_collada.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

namespace pt {
namespace {

// A triangle in world space, and the diffuse colour of its material if that is stated.
struct Face {
  std::array<Vec3, 3> p, n;
  std::optional<Rgb> diffuse;
};

Vec3 doubled_area(const Face& f) { return cross(f.p[1] - f.p[0], f.p[2] - f.p[0]); }

std::vector<Face> our_faces(const LoadedScene& loaded) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < loaded.scene.primitives.triangles.size(); ++i) {
    const Triangle& t = loaded.scene.primitives.triangles[i];
    const Rgb albedo = loaded.scene.materials[loaded.scene.material_of[i]].albedo;
    faces.push_back({{t.p0, t.p1, t.p2}, {t.n0, t.n1, t.n2}, albedo});
  }
  return faces;
}

std::optional<Rgb> diffuse_of(const aiMaterial& material) {
  aiColor3D color;
  if (material.GetTextureCount(aiTextureType_DIFFUSE) > 0) return std::nullopt;
  if (material.Get(AI_MATKEY_COLOR_DIFFUSE, color) != AI_SUCCESS) return std::nullopt;
  return Rgb{color.r, color.g, color.b};
}

// Adds the triangles of a mesh that have an area. Without normals in the file they are zero.
void add_mesh(const aiMesh& mesh, const aiMatrix4x4& to_world, std::optional<Rgb> diffuse,
              std::vector<Face>& faces) {
  const aiMatrix3x3 for_normals = aiMatrix3x3(to_world).Inverse().Transpose();
  for (unsigned int i = 0; i < mesh.mNumFaces; ++i) {
    if (mesh.mFaces[i].mNumIndices != 3) continue;
    Face face{{}, {}, diffuse};
    for (int k = 0; k < 3; ++k) {
      const unsigned int at = mesh.mFaces[i].mIndices[k];
      const aiVector3D p = to_world * mesh.mVertices[at];
      face.p[k] = {p.x, p.y, p.z};
      if (!mesh.HasNormals()) continue;
      aiVector3D n = for_normals * mesh.mNormals[at];
      n.NormalizeSafe();
      face.n[k] = {n.x, n.y, n.z};
    }
    if (std::isnormal(length_squared(doubled_area(face)))) faces.push_back(face);
  }
}

void add_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent,
              std::vector<Face>& faces) {
  const aiMatrix4x4 to_world = parent * node.mTransformation;
  for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    add_mesh(mesh, to_world, diffuse_of(*scene.mMaterials[mesh.mMaterialIndex]), faces);
  }
  for (unsigned int i = 0; i < node.mNumChildren; ++i) {
    add_node(scene, *node.mChildren[i], to_world, faces);
  }
}

// assimp's root scales by the unit of the file, which we ignore, and turns its up axis to y: as we
// do, but for half a turn about y.
std::vector<Face> their_faces(const aiScene& scene) {
  const aiMatrix4x4 root = scene.mRootNode->mTransformation;
  const auto unit = static_cast<float>(1 / std::cbrt(std::abs(root.Determinant())));
  const float turn = root.b2 * unit < 0.5f ? -unit : unit;
  aiMatrix4x4 map;
  aiMatrix4x4::Scaling({turn, unit, turn}, map);
  std::vector<Face> faces;
  add_node(scene, *scene.mRootNode, map, faces);
  return faces;
}

// Faces in the order of a coordinate along which the middles of two seldom coincide.
using Sorted = std::multimap<double, const Face*>;
double place(const Face& face) {
  return dot(face.p[0] + face.p[1] + face.p[2], Vec3{0.1357, 0.2718, 0.3141});
}

Sorted sorted(const std::vector<Face>& faces) {
  Sorted result;
  for (const Face& face : faces) result.emplace(place(face), &face);
  return result;
}

// Corner k of a face is the corner order[k] of another that has the same corners.
using Order = std::array<int, 3>;
std::optional<Order> same_corners(const Face& a, const Face& b, double tolerance) {
  constexpr Order kOrders[] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (const Order order : kOrders) {
    const auto is_near = [&](int k) { return length(a.p[k] - b.p[order[k]]) <= tolerance; };
    if (is_near(0) && is_near(1) && is_near(2)) return order;
  }
  return std::nullopt;
}

struct Differences {
  std::size_t unmatched = 0, winding = 0, normals = 0, colours = 0;
  bool are_cuts = false;  // the unmatched triangles can be the same polygons, cut otherwise
};

bool colours_differ(Rgb ours, Rgb theirs) {
  return std::abs(ours.r - std::min(theirs.r, 1.0)) > 1e-3 ||
         std::abs(ours.g - std::min(theirs.g, 1.0)) > 1e-3 ||
         std::abs(ours.b - std::min(theirs.b, 1.0)) > 1e-3;
}

void compare_pair(const Face& ours, const Face& theirs, Order order, Differences& found) {
  if (order[1] != (order[0] + 1) % 3) ++found.winding;
  bool differ = false;
  for (int k = 0; k < 3; ++k) {
    const Vec3 n = theirs.n[order[k]];
    differ = differ || (n != Vec3{} && dot(ours.n[k], n) < 0.999);
  }
  if (differ) ++found.normals;
  if (theirs.diffuse && colours_differ(*ours.diffuse, *theirs.diffuse)) ++found.colours;
}

Differences compare(const std::vector<Face>& ours, const std::vector<Face>& theirs,
                    double tolerance) {
  Differences found;
  Box ours_left, theirs_left;
  Sorted left = sorted(theirs);
  for (const Face& face : ours) {
    auto at = left.lower_bound(place(face) - 2 * tolerance);
    std::optional<Order> order;
    for (; at != left.end() && at->first <= place(face) + 2 * tolerance; ++at) {
      if ((order = same_corners(face, *at->second, tolerance))) break;
    }
    if (!order) {
      ++found.unmatched;
      for (const Vec3 p : face.p) ours_left.grow(p);
      continue;
    }
    compare_pair(face, *at->second, *order, found);
    left.erase(at);
  }
  for (const auto& [key, face] : left) {
    for (const Vec3 p : face->p) theirs_left.grow(p);
  }
  found.are_cuts = left.size() == found.unmatched &&
                   max_abs(ours_left.min - theirs_left.min) <= tolerance &&
                   max_abs(ours_left.max - theirs_left.max) <= tolerance;
  return found;
}

double largest_coordinate(const std::vector<Face>& faces) {
  double largest = 0;
  for (const Face& face : faces) {
    for (const Vec3 p : face.p) largest = std::max(largest, max_abs(p));
  }
  return largest;
}

void report(const std::vector<Face>& ours, const std::vector<Face>& theirs) {
  if (ours.size() != theirs.size()) {
    fmt::print("triangles\t{} here, {} there\n", ours.size(), theirs.size());
  }
  const Differences found = compare(ours, theirs, 1e-5 * largest_coordinate(ours));
  const std::pair<const char*, std::size_t> counts[] = {
      {found.are_cuts ? "cut otherwise" : "corners", found.unmatched},
      {"winding order", found.winding},
      {"normals", found.normals},
      {"diffuse colour", found.colours}};
  bool is_same = ours.size() == theirs.size();
  for (const auto& [kind, count] : counts) {
    if (count > 0) fmt::print("{}\tof {} of {} triangles\n", kind, count, ours.size());
    is_same = is_same && count == 0;
  }
  if (is_same) fmt::print("same\t{} triangles\n", ours.size());
}

// The last warning or error. assimp logs parts that it leaves out, and still calls the file read.
struct LastComplaint : Assimp::LogStream {
  std::string text;
  void write(const char* message) override { text.assign(message, std::strcspn(message, "\n")); }
};

void run(const char* file) {
  auto* complaint = new LastComplaint;  // the logger deletes it
  Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0)
      ->attachStream(complaint, Assimp::Logger::Warn | Assimp::Logger::Err);
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene = importer.ReadFile(file, aiProcess_Triangulate);
  const bool has_faces = scene != nullptr && scene->mRootNode != nullptr && scene->mNumMeshes > 0;
  if (!has_faces) fmt::print("assimp shows nothing\t{}\n", complaint->text);
  try {
    const LoadedScene loaded = load_collada(file);
    if (has_faces) report(our_faces(loaded), their_faces(*scene));
    if (!has_faces) fmt::print("only here\t{} triangles\n", loaded.scene.primitives.size());
  } catch (const Error& error) {
    fmt::print("{}\t{}\n", has_faces ? "only there" : "neither", error.what());
  }
}

}  // namespace
}  // namespace pt

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  pt::run(argv[1]);
}
