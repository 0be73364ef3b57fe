#pragma once

#include "pt/scene/collada/document.h"
#include "pt/scene/material.h"

#include <string>
#include <vector>

namespace pt {

// The <material> as a Material: emission from the course's technique; the albedo from the course's
// technique, else from profile_COMMON, else 0.5. Adds a note for each thing that it ignores.
Material read_material(const ColladaDocument& document, const XMLElement& material,
                       std::vector<std::string>& notes);

}  // namespace pt
