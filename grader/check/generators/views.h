#pragma once

#include "grader/check/generators/cameras.h"
#include "grader/check/generators/generators.h"
#include "grader/check/generators/special.h"
#include "grader/check/language/cases.h"
#include "grader/check/language/property.h"
#include "grader/check/mocks/scripted_radiance.h"
#include "pt/scene/view.h"

#include <cmath>
#include <iterator>
#include <string>
#include <utility>

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

// Ordinary ones, as one value.
inline rc::Gen<pt::PathSettings> usual_settings() {
  return rc::gen::exec([] {
    using Direct = pt::PathSettings::Direct;
    pt::PathSettings s;
    s.light_samples = *whole(1, 9);
    s.direct = *rc::gen::element(Direct::lights, Direct::hemisphere);
    s.survival = *real(0.1, 1);
    s.from = *whole(0, 3);
    s.to = *whole(3, 9);
    s.show_normals = *rc::gen::arbitrary<bool>();
    return s;
  });
}
inline std::string show(const pt::PathSettings& s) {
  return fmt::format(
      "bounces {} to {}, {} samples {}, survival {:.4g}{}", s.from, s.to, s.light_samples,
      s.direct == pt::PathSettings::Direct::lights ? "of lights" : "of the hemisphere", s.survival,
      s.show_normals ? ", normals" : "");
}

// A sphere beneath a number of lights. radiance() must get this scene itself or an equal one: a scene
// that the judge does not know ends the call.
inline pt::Scene scene_with(int lights) {
  pt::Scene scene;
  scene.primitives.spheres.push_back({{0, 0, 0}, 1});
  scene.material_of.push_back(0);
  scene.materials.emplace_back();
  for (int i = 0; i < lights; ++i) {
    scene.lights.emplace_back(pt::PointLight{{0, 3, 1.0 * i}, {1, 1, 1}});
  }
  return scene;
}
inline int some_lights() { return draw("lights", rc::gen::oneOf(whole(0, 9), whole(10, 300))); }
inline pt::Scene some_scene() { return scene_with(some_lights()); }

// Changes of one number of a call, or of two that change places or keep their sum: a task that remembers the call by all other numbers
// takes it for the one before. A call has a pixel (of a camera and a size), settings, a number of lights and a seed.
template <class Call>
OtherCases<Call> other_pixels() {
  OtherCases<Call> all{
      [](Call& c) { c.pixel.width *= 2; },
      [](Call& c) { c.pixel.height *= 2; },
      [](Call& c) { c.pixel.x = (c.pixel.x > 0 ? c.pixel.x : c.pixel.width) - 1; },
      [](Call& c) { c.pixel.y = (c.pixel.y > 0 ? c.pixel.y : c.pixel.height) - 1; },
      [](Call& c) {
        std::swap(c.pixel.x, c.pixel.y);
        std::swap(c.pixel.width, c.pixel.height);
      },
      [](Call& c) { c.pixel.camera.hfov_deg *= 0.5; },
      [](Call& c) { c.pixel.camera.vfov_deg *= 0.5; },
      [](Call& c) { std::swap(c.pixel.camera.hfov_deg, c.pixel.camera.vfov_deg); },
      [](Call& c) { c.pixel.camera.near_clip += 1; },
      [](Call& c) { c.pixel.camera.far_clip = 2 * c.pixel.camera.far_clip + 1; },
      [](Call& c) { exchange_or_add_in({&c.pixel.camera.position}); },
      [](Call& c) {
        const pt::Frame& f = c.pixel.camera.camera_to_world;
        c.pixel.camera.camera_to_world = {f.y, f.z, f.x};
      },
  };
  for (int axis = 0; axis < 3; ++axis) {
    all.emplace_back([axis](Call& c) { c.pixel.camera.position[axis] += 1; });
  }
  return all;
}

template <class Call>
OtherCases<Call> other_settings() {
  using Direct = pt::PathSettings::Direct;
  return {
      [](Call& c) { ++c.lights; },
      [](Call& c) { ++c.settings.light_samples; },
      [](Call& c) {
        const bool by_lights = c.settings.direct == Direct::lights;
        c.settings.direct = by_lights ? Direct::hemisphere : Direct::lights;
      },
      [](Call& c) { c.settings.survival *= 0.5; },
      [](Call& c) { c.settings.from = (c.settings.from > 0 ? 0 : c.settings.to); },
      [](Call& c) { ++c.settings.to; },
      [](Call& c) { c.settings.show_normals = !c.settings.show_normals; },
      [](Call& c) { std::swap(c.settings.from, c.settings.to); },
      [](Call& c) { std::swap(c.settings.light_samples, c.settings.to); },
      [](Call& c) { c.settings.to += std::exchange(c.settings.light_samples, 1) - 1; },
  };
}

// These, and what a task adds.
template <class Call>
OtherCases<Call> other_calls(OtherCases<Call> all) {
  for (const auto& more : {other_pixels<Call>(), other_settings<Call>()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  all.emplace_back([](Call& c) { ++c.seed; });
  return all;
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
