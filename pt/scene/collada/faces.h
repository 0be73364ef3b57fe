#pragma once

#include "pt/scene/collada/document.h"

#include <vector>

namespace pt {

// The lists of indices of one set of faces: corner i of the set reads its indices at
// i * stride + offset, and face j has corners[j] of them.
struct Faces {
  std::vector<int> corners;
  std::vector<int> indices;
};

// Returns whether the element is a set of faces: <polylist>, <triangles>, <polygons>, <tristrips>
// or <trifans>.
bool is_set_of_faces(const XMLElement& element);

// The faces of a set with `stride` indices per corner. Strips and fans are unfolded to triangles.
Faces read_faces(const Document& document, const XMLElement& set, int stride);

}  // namespace pt
