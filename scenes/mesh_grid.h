#pragma once

#include "scenes/meshes.h"

#include <array>
#include <vector>

// Parts that the formulas of the meshes share.

namespace scenes {

// Throws pt::Error unless every kind of mesh can have this number of triangles.
void check_count(int triangles);

// The faces of a grid of rows x columns points, row after row; a grid that wraps joins its last row
// (or column) to its first. The outside is on the side of cross(along the row, along the column).
std::vector<std::array<int, 3>> grid_faces(int rows, int columns, bool wrap_rows,
                                           bool wrap_columns);

// Adds a flat triangle that shares no points, anticlockwise seen from outside.
void add_facet(Mesh& mesh, pt::Vec3 p0, pt::Vec3 p1, pt::Vec3 p2);

}  // namespace scenes
