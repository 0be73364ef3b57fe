#pragma once

#include "scenes/meshes.h"

#include <string>

namespace scenes {

// Around a mesh.
enum class Setting {
  open,  // nothing but a sky and a sun
  room   // scenes/box_empty.dae
};

// A scene file of the course's dialect with the mesh, scaled to stand in the room. Points have
// `decimals` digits after the decimal point, normals one fewer. The file begins with the comment,
// which may not contain two hyphens in a row.
std::string collada_text(const Mesh& mesh, Setting setting, int decimals,
                         const std::string& comment);

}  // namespace scenes
