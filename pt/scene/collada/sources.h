#pragma once

#include "pt/math/vec3.h"
#include "pt/scene/collada/document.h"

#include <unordered_map>
#include <vector>

namespace pt {

// The vectors of each <source> that was read. Sets of faces share them.
using Sources = std::unordered_map<const XMLElement*, std::vector<Vec3>>;

// The indices of a corner in the lists of its set. The normal's means nothing if there are none.
struct Corner {
  int position;
  int normal;
};

// The arrays that the corners of a set of faces point into, and the places of a corner's indices.
struct FaceInputs {
  const std::vector<Vec3>* positions = nullptr;
  const std::vector<Vec3>* normals = nullptr;  // null if the file has none
  int position_offset = 0;
  int normal_offset = 0;

  // Throws Error, which names the element `at`, if an index is outside its array.
  Corner corner(const Document& document, const XMLElement& at, const int* indices) const;
};

// The number of indices per corner of a set of faces.
int read_stride(const Document& document, const XMLElement& faces);

// Adds sources that were not read before to `sources`, into which the result points.
FaceInputs read_inputs(const Document& document, const XMLElement& faces, Sources& sources);

}  // namespace pt
