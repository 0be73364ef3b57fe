#pragma once

#include "pt/math/rgb.h"

#include <string>

namespace pt {

// A Lambertian surface that may emit. It reflects on both sides and emits on the side of the
// geometric normal.
struct Material {
  std::string name;
  Rgb albedo{0.5, 0.5, 0.5};  // in [0, 1]
  Rgb emission;               // radiance

  // A kind of material that no task models ("mirror", "glass", ...), else empty. The normals view
  // can show its surfaces; light cannot be computed on them.
  std::string unsupported;

  // The index in its scene of the material of the side away from the geometric normal, which emits to
  // that side; -1: this material, and no emission there.
  int behind = -1;
};

}  // namespace pt
