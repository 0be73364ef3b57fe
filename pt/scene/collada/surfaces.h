#pragma once

#include "pt/scene/collada/emitters.h"
#include "pt/scene/collada/nodes.h"
#include "pt/scene/load_collada.h"

#include <vector>

namespace pt {

// All surfaces in world space, and the emitting surfaces among them.
struct Surfaces {
  Scene scene;  // without lights
  std::vector<Emitter> emitters;
  bool ignores_emission = false;  // of some material, in profile_COMMON
};

// If a map mirrors, the winding order is reversed, so that a geometric normal stays on the side of
// the surface on which the file has it. Triangles without an area are left out.
Surfaces read_surfaces(const Document& document, const std::vector<Instance>& geometries,
                       const LoadOptions& options);

}  // namespace pt
