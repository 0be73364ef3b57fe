#pragma once

#include "pt/math/vec3.h"
#include "pt/scene/collada/document.h"
#include "pt/scene/collada/sources.h"

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

// The faces of one set, in order, as triangles.
struct MeshPart {
  std::string material_symbol;  // empty where the file has none
  const std::vector<Vec3>* positions = nullptr;
  const std::vector<Vec3>* normals = nullptr;  // null where the file has none
  std::vector<Corner> corners;                 // three per triangle

  std::size_t size() const { return corners.size() / 3; }
  FileTriangle triangle(std::size_t i) const;
};

// A mesh, or a sphere around the origin. The parts point into its sources.
struct ColladaGeometry {
  std::vector<MeshPart> parts;
  std::optional<double> sphere_radius;
  Sources sources;
};

ColladaGeometry read_geometry(const ColladaDocument& document, const XMLElement& geometry);

}  // namespace pt
