#include "scenes/meshes.h"

#include "pt/error.h"
#include "scenes/mesh_grid.h"

#include <string>

namespace scenes {

using pt::Vec3;

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"sphere", make_sphere, "A sphere made of triangles: what its curved twin should look like."},
      {"blob", make_blob,
       "A smooth blob with many bumps in place of a scanned model: it casts shadows on itself."},
      {"coil", make_coil,
       "A tube wound into a coil: many boxes along each ray, and shadows within shadows."},
      {"vase", make_vase,
       "A vase, a surface of revolution: smooth normals, a thin wall and a dark inside."},
      {"gems", make_gems, "Three cut stones: flat facets, each with a normal of its own."},
      {"terrain", make_terrain, "Hills: a flat, even spread of triangles, open below."},
      {"slivers", make_slivers,
       "Long thin triangles, criss-cross: their boxes overlap, whatever the hierarchy."}};
  return all;
}

pt::Primitives to_primitives(const Mesh& mesh) {
  pt::Primitives primitives;
  primitives.triangles.reserve(mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces) {
    primitives.triangles.push_back({mesh.points[a], mesh.points[b], mesh.points[c], mesh.normals[a],
                                    mesh.normals[b], mesh.normals[c]});
  }
  return primitives;
}

void check_count(int triangles) {
  if (triangles >= 100 && triangles <= 10'000'000) return;
  throw pt::Error("a mesh of " + std::to_string(triangles) +
                  " triangles cannot be made: ask for 100 to 10000000");
}

std::vector<std::array<int, 3>> grid_faces(int rows, int columns, bool wrap_rows,
                                           bool wrap_columns) {
  const int row_count = wrap_rows ? rows : rows - 1;
  const int column_count = wrap_columns ? columns : columns - 1;
  std::vector<std::array<int, 3>> faces;
  faces.reserve(2 * static_cast<std::size_t>(row_count) * column_count);
  for (int row = 0; row < row_count; ++row) {
    for (int column = 0; column < column_count; ++column) {
      const int here = row * columns;
      const int above = (row + 1) % rows * columns;
      const int right = (column + 1) % columns;
      faces.push_back({here + column, here + right, above + right});
      faces.push_back({here + column, above + right, above + column});
    }
  }
  return faces;
}

void add_facet(Mesh& mesh, Vec3 p0, Vec3 p1, Vec3 p2) {
  const Vec3 n = normalize(cross(p1 - p0, p2 - p0));
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {p0, p1, p2});
  mesh.normals.insert(mesh.normals.end(), {n, n, n});
  mesh.faces.push_back({first, first + 1, first + 2});
}

}  // namespace scenes
