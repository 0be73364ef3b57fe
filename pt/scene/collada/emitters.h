#pragma once

#include "pt/geometry/sphere.h"
#include "pt/geometry/triangle.h"
#include "pt/scene/light.h"

#include <span>
#include <string>

namespace pt {

// An emitting surface as a light. Two triangles that form a parallelogram are a RectangleLight,
// other meshes are a MeshLight, and a sphere is a SphereLight.
struct Emitter {
  Light light;
  Rgb radiance;
  std::string name;  // in quotes
  Vec3 center;       // of its area
  Vec3 n;            // unit, on the emitting side if the surface is flat; else zero
  double size = 0;   // from end to end
};

// The triangles have an area and world-space corners; each emits on its geometric normal's side.
Emitter mesh_emitter(std::span<const Triangle> triangles, Rgb radiance, const std::string& name);
Emitter sphere_emitter(const Sphere& sphere, Rgb radiance, const std::string& name);

}  // namespace pt
