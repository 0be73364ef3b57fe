#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/scenes/scenes.h"

#include <cmath>
#include <string>

namespace grader::check::direct_lights_inputs {

// A place on a unit cylinder around the z axis, at this angle from the x axis.
inline pt::Vec3 on_cylinder(double angle, double z) {
  return {std::cos(angle), std::sin(angle), z};
}

// A tube of flat sides, whose normals are those of the cylinder around it.
inline void add_tube(pt::Scene& scene, int sides, double turn) {
  const auto side = 2 * pt::kPi / sides;
  for (int i = 0; i < sides; ++i) {
    const double from = turn + i * side, to = from + side;
    const pt::Vec3 a = on_cylinder(from, -4), b = on_cylinder(to, -4), c = on_cylinder(to, 4),
                   d = on_cylinder(from, 4);
    const pt::Vec3 left = on_cylinder(from, 0), right = on_cylinder(to, 0);
    scene.primitives.triangles.push_back({a, b, c, left, right, right});
    scene.primitives.triangles.push_back({a, c, d, left, right, left});
  }
  scene.material_of.assign(scene.primitives.triangles.size(), 0);
}

// A point of such a tube whose shading normal faces a directional light, which is along the x axis.
inline Situation lit_tube(int sides) {
  Situation s;
  s.scene.materials.resize(1);
  add_tube(s.scene, sides, *real(0, 2 * pt::kPi));
  s.scene.lights = {pt::DirectionalLight{{-1, 0, 0}, pt::gray(1)}};
  s.scene = ready(s.scene);
  const pt::Vec3 seen = on_cylinder(*real(-pt::kPi / 2, pt::kPi / 2), *real(-1, 1));
  const pt::Vec3 outwards{seen.x, seen.y, 0};
  const pt::Ray ray{seen + outwards, -outwards};
  s.point = surface_point(s.scene, ray, s.scene.closest(ray).value());
  s.text = "a tube of " + std::to_string(sides) + " sides";
  return s;
}

}  // namespace grader::check::direct_lights_inputs
