#pragma once

#include "pt/math/transform.h"
#include "pt/scene/collada/document.h"

#include <string>
#include <vector>

namespace pt {

// A <matrix>, or another element that holds 16 numbers, row by row. A camera's may lack its last.
// Adds a note for each thing that it corrects.
Transform read_matrix(const ColladaDocument& document, const XMLElement& matrix, bool holds_camera);

// The map from a node's space to its parent's: its <matrix>, <translate>, <rotate>, <scale> and
// <lookat> in document order, so that the last listed acts first on a point. Adds a note for each
// thing that it corrects.
Transform node_transform(const ColladaDocument& document, const XMLElement& node);

// Throws Error if a number of the map is infinite, NaN or too large for computing with geometry.
void check_finite(const ColladaDocument& document, const XMLElement& at, const Transform& map);

// The largest coordinate that a scene may have: its cross products still have finite squares.
inline constexpr double kMaxCoordinate = 1e30;

}  // namespace pt
