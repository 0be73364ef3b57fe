#pragma once

#include "pt/math/vec3.h"
#include "pt/scene/collada/document.h"

#include <unordered_map>
#include <vector>

namespace pt {

// The vectors of each <source> that was read. Sets of faces share them.
using Sources = std::unordered_map<const XMLElement*, std::vector<Vec3>>;

// The arrays that the corners of a set of faces point into, and the places of a corner's indices.
// Indices are checked when they are used: an error names the element `at`.
struct FaceInputs {
  const std::vector<Vec3>* positions = nullptr;
  const std::vector<Vec3>* normals = nullptr;  // null if the file has none
  int stride = 1;                              // indices per corner
  int position_offset = 0;
  int normal_offset = 0;

  Vec3 position(const ColladaDocument& document, const XMLElement& at, const int* corner) const;
  Vec3 normal(const ColladaDocument& document, const XMLElement& at, const int* corner) const;
};

// Adds sources that were not read before to `sources`. The result points into it.
FaceInputs read_inputs(const ColladaDocument& document, const XMLElement& faces, Sources& sources);

}  // namespace pt
