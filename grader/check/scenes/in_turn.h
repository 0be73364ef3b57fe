#pragma once

#include "grader/check/generators/special.h"
#include "grader/check/scenes/scenes.h"

// Two calls in turn in the same scene but for two numbers of the surface or of the light, which change places or keep their
// sum. The answers to both are known.

namespace grader::check {

// Below a point light, so that every estimate is exact. The numbers are those of the albedo, of the intensity, or of the place of
// the light or of the surface.
inline rc::Gen<InTurn<Situation>> below_a_point_light_in_turn() {
  return rc::gen::exec([] {
    const auto place = [](double low, double high) {
      return pt::Vec3{*real(low, high), *real(low, high), *real(low, high)};
    };
    pt::Rgb albedo = *color(0.05, 0.5), intensity = *color(0.5, 4);
    pt::Vec3 of_light = place(2, 4), of_surface = place(0, 0.5);
    const pt::Vec3 wo = *direction_above();
    const auto made = [&] {
      SceneMaker maker({{}, of_surface, 1});
      return maker.point_light(of_light - of_surface, intensity).point(albedo, wo).done();
    };
    const Situation before = made();
    switch (*whole(0, 3)) {
      case 0:
        exchange_or_add_in(albedo);
        break;
      case 1:
        exchange_or_add_in(intensity);
        break;
      case 2:
        exchange_or_add_in({&of_light});
        break;
      default:
        exchange_or_add_in({&of_surface});
    }
    return InTurn<Situation>{before, made()};
  });
}

// Under a sky, with numbers of the albedo or of the sky's radiance.
inline rc::Gen<InTurn<Situation>> under_the_sky_in_turn() {
  return rc::gen::exec([] {
    pt::Rgb albedo = *color(0.05, 0.5), radiance = *color(0.5, 4);
    const pt::Vec3 wo = *direction_above();
    const auto made = [&] { return SceneMaker({}).sky(radiance).point(albedo, wo).done(); };
    const Situation before = made();
    exchange_or_add_in(*whole(0, 1) == 0 ? albedo : radiance);
    return InTurn<Situation>{before, made()};
  });
}

}  // namespace grader::check
