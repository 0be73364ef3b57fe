#pragma once

#include "pt/scene/export/export.h"

#include <string>
#include <vector>

#include <fmt/format.h>

// The parts of a scene that all formats write.

namespace pt {

// All digits of a number, "1 2 3" of three.
inline std::string digits(double value) { return fmt::format("{}", value); }
inline std::string digits(Vec3 v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }
inline std::string digits(Rgb c) { return fmt::format("{} {} {}", c.r, c.g, c.b); }

// The triangles of one material; flat ones have the normal of their face at each corner, and are apart from smooth ones.
struct TriangleGroup {
  int material = 0;
  bool flat = true;
  std::vector<Triangle> triangles;
};
std::vector<TriangleGroup> triangle_groups(const Scene& scene);

inline const Material& material(const Scene& scene, int primitive) {
  return scene.materials[scene.material_of[primitive]];
}

// Throws Error if an area light has no surface that emits.
void require_surfaces(const Scene& scene, const std::string& name);

}  // namespace pt
