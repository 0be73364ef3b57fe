#pragma once

#include "pt/math/vec3.h"
#include "pt/scene/collada/document.h"

#include <unordered_map>
#include <vector>

namespace pt {

// The vectors of each <source> that was read: sets of faces share them.
using Sources = std::unordered_map<const XMLElement*, std::vector<Vec3>>;

// The arrays that the corners of a set of faces point into, and where each of a corner's indices
// stands. Indices are checked as they are used: an error names the element `at`.
struct FaceInputs {
  const std::vector<Vec3>* positions = nullptr;
  const std::vector<Vec3>* normals = nullptr;  // null where the file has none
  int stride = 1;                              // indices per corner
  int position_offset = 0;
  int normal_offset = 0;

  Vec3 position(const ColladaDocument& document, const XMLElement& at, const int* corner) const;
  Vec3 normal(const ColladaDocument& document, const XMLElement& at, const int* corner) const;
};

// Adds to `sources` what was not read before; the result points into it.
FaceInputs read_inputs(const ColladaDocument& document, const XMLElement& faces, Sources& sources);

}  // namespace pt
