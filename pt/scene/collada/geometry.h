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
  FaceInputs inputs;
  std::vector<Corner> corners{};  // three per triangle

  std::size_t size() const { return corners.size() / 3; }
  FileTriangle triangle(std::size_t i) const;
};

// A mesh, or a sphere around the origin. The parts point into its sources.
struct Geometry {
  std::vector<MeshPart> parts;
  std::optional<double> sphere_radius;
  Sources sources;
};

Geometry read_geometry(const Document& document, const XMLElement& geometry);

}  // namespace pt
