#pragma once

#include "grader/check/generators/cameras.h"
#include "grader/check/generators/generators.h"
#include "grader/check/language/property.h"
#include "grader/check/mocks/scripted_radiance.h"
#include "pt/scene/view.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

// Views for the tasks that estimate a pixel, and what radiance() must see of them.

namespace grader::check {

// Settings from the whole range of each.
inline pt::PathSettings some_settings() {
  pt::PathSettings s;
  s.light_samples = draw("light samples", rc::gen::oneOf(whole(1, 9), whole(10, 100000)));
  s.direct = draw("by lights", rc::gen::arbitrary<bool>()) ? pt::PathSettings::Direct::lights
                                                           : pt::PathSettings::Direct::hemisphere;
  s.survival = draw("survival", rc::gen::oneOf(real(0.05, 1), rc::gen::just(1.0)));
  s.from = draw("from", whole(0, 5));
  s.to = s.from + draw("more bounces", rc::gen::oneOf(whole(0, 9), whole(10, 100000)));
  s.show_normals = draw("normals", rc::gen::arbitrary<bool>());
  return s;
}

// A sphere beneath a number of lights. radiance() must get this scene itself or an equal one: a scene
// that the judge does not know ends the call.
inline pt::Scene some_scene() {
  pt::Scene scene;
  scene.primitives.spheres.push_back({{0, 0, 0}, 1});
  scene.material_of.push_back(0);
  scene.materials.emplace_back();
  const int lights = draw("lights", rc::gen::oneOf(whole(0, 9), whole(10, 300)));
  for (int i = 0; i < lights; ++i) {
    scene.lights.emplace_back(pt::PointLight{{0, 3, 1.0 * i}, {1, 1, 1}});
  }
  return scene;
}

inline void expect_seen(const RadianceCall& call, const pt::PathSettings& right,
                        const pt::Scene& scene) {
  const pt::PathSettings& got = call.settings;
  expect_equal("lights of the scene that radiance() gets", call.lights, std::ssize(scene.lights));
  expect(got.light_samples == right.light_samples && got.direct == right.direct &&
             got.survival == right.survival && got.from == right.from && got.to == right.to &&
             got.show_normals == right.show_normals,
         "the view's settings", "other settings");
}

// Fails unless a ray begins at the camera and has its clip range, as the rays of camera_ray do. The
// submission's own camera_ray may be in single precision.
inline void expect_from_camera(const pt::Ray& ray, const pt::Camera& camera) {
  constexpr double kSingle = 1e-6;
  const auto [position, frame, hfov, vfov, near, far] = camera;
  const bool right = length(ray.origin - position) <= kSingle * length(position) &&
                     std::abs(ray.t_min - near) <= kSingle * near && ends_at(ray.t_max, far);
  const auto words = [](pt::Vec3 from, double low, double high) {
    return fmt::format("from {}, with t from {} to {}", show(from), show(low), show(high));
  };
  if (!right) {
    expect(false, "a ray of camera_ray: " + words(position, near, far),
           words(ray.origin, ray.t_min, ray.t_max));
  }
}

}  // namespace grader::check
