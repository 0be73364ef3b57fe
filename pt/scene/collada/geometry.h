#pragma once

#include "pt/math/vec3.h"
#include "pt/scene/collada/document.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pt {

// A triangle as the file has it, in the geometry's own space. Normals have any length, or are zero
// if the file has none.
struct FileTriangle {
  Vec3 p[3];
  Vec3 n[3];
};

// The faces of a <polylist>, <triangles> or <polygons>, in order, as fans of triangles.
struct MeshPart {
  std::string material_symbol;  // empty where the file has none
  std::vector<FileTriangle> triangles;
  std::size_t without_surface = 0;  // faces of fewer than three corners
};

// A mesh, or a sphere around the origin.
struct ColladaGeometry {
  std::vector<MeshPart> parts;
  std::optional<double> sphere_radius;
  std::vector<std::string> notes;
};

ColladaGeometry read_geometry(const ColladaDocument& document, const XMLElement& geometry);

}  // namespace pt
