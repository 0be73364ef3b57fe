#pragma once

#include "pt/scene/collada/nodes.h"
#include "pt/scene/load_collada.h"

#include <optional>
#include <vector>

namespace pt {

// The last camera of the scene that has a perspective, if there is one.
std::optional<FileCamera> read_camera(const Document& document,
                                      const std::vector<Instance>& cameras);

}  // namespace pt
