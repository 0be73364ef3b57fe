#pragma once

#include "pt/scene/collada/nodes.h"
#include "pt/scene/load_collada.h"

#include <optional>
#include <string>
#include <vector>

namespace pt {

// The last camera of the scene that has a perspective, if there is one. Adds a note for each thing
// that it ignores or corrects.
std::optional<FileCamera> read_camera(const ColladaDocument& document,
                                      const std::vector<Instance>& cameras);

}  // namespace pt
