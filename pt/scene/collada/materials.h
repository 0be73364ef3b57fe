#pragma once

#include "pt/scene/collada/document.h"
#include "pt/scene/load_collada.h"
#include "pt/scene/material.h"

namespace pt {

struct FileMaterial {
  Material material;
  bool ignores_emission = false;  // an emission colour of profile_COMMON
};

// The <material> as a Material: emission from the course's technique, or from profile_COMMON if the
// options ask for it; the albedo from the course's technique, else from profile_COMMON, else 0.5.
FileMaterial read_material(const Document& document, const XMLElement& material,
                           const LoadOptions& options);

}  // namespace pt
