#pragma once

#include "scenes/meshes.h"

#include <string>

namespace scenes {

// Around a mesh.
enum class Setting {
  open,  // nothing but a sky and a sun
  room   // scenes/box_empty.dae
};

// A scene file of the course's dialect that holds the mesh once, scaled to stand in the room, with
// `decimals` digits after the point for its points and one fewer for its normals. The comment opens
// the file; it may not contain two hyphens in a row.
std::string collada_text(const Mesh& mesh, Setting setting, int decimals,
                         const std::string& comment);

}  // namespace scenes
