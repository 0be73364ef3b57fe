#pragma once

#include "pt/math/frame.h"
#include "pt/math/transform.h"
#include "pt/scene/collada/document.h"

#include <string>

namespace pt {

// A <matrix>, or another element that holds 16 numbers, row by row. A camera's may lack its last.
Transform read_matrix(const Document& document, const XMLElement& matrix, bool holds_camera);

// The map from a node's space to its parent's: its <matrix>, <translate>, <rotate>, <scale> and
// <lookat> in document order, so that the last listed acts first on a point.
Transform node_transform(const Document& document, const XMLElement& node);

// The frame whose z axis is the unit vector z and whose y axis is as near to `up` as possible. If
// `up` is along z, the note is added, and the y axis of space takes its place.
Frame upright_frame(const Document& document, Vec3 z, Vec3 up, const std::string& note);

// Throws Error if a number of the map is infinite, NaN or too large for computing with geometry.
void check_finite(const Document& document, const XMLElement& at, const Transform& map);

// The largest coordinate that a scene may have: its cross products still have finite squares.
inline constexpr double kMaxCoordinate = 1e30;

}  // namespace pt
