#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/scenes/scenes.h"
#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

// Directions in the local frame of a surface, and albedos.

namespace grader::check::diffuse_bsdf_inputs {

using pt::Rgb;
using pt::Vec3;

// Returns the unit direction of height z above the surface.
inline Vec3 at(double z, double phi) {
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

// A unit direction above the surface, steep or grazing, or the normal itself.
inline rc::Gen<Vec3> above() {
  return direction_above_at(rc::gen::oneOf(real(1e-3, 1), magnitude(1e-9, 1), rc::gen::just(1.0)));
}

// The product of the heights of two of these directions is below the precision of a double.
inline rc::Gen<Vec3> grazing() { return direction_above_at(magnitude(1e-9, 1e-8)); }

// An albedo of any colour, bright or dark, or with channels of 0, 1e-4, 1/2 or 1.
inline rc::Gen<Rgb> any_albedo() {
  const auto special = rc::gen::element(0.0, 1e-4, 0.5, 1.0);
  const auto dark =
      rc::gen::map(rc::gen::pair(magnitude(1e-9, 1), color(0.1, 1)),
                   [](const std::pair<double, Rgb>& p) { return p.first * p.second; });
  return rc::gen::oneOf(color(), dark,
                        rc::gen::map(rc::gen::tuple(special, special, special),
                                     [](const std::tuple<double, double, double>& c) {
                                       return Rgb{std::get<0>(c), std::get<1>(c), std::get<2>(c)};
                                     }));
}

// Black, gray, white, or brightest in one channel. The density must be the same for all of them.
inline constexpr int kAlbedoKinds = 6, kFirstBright = 3;
inline rc::Gen<Rgb> albedo_of_kind(int kind) {
  return rc::gen::exec([kind] {
    if (kind == 1) return pt::gray(*real(0.1, 0.9));
    if (kind < 3) return pt::gray(kind == 2 ? 1 : 0);
    Rgb albedo = 0.6 * *color();
    albedo[kind - 3] = *rc::gen::oneOf(real(0.7, 1), rc::gen::just(1.0));
    return albedo;
  });
}

inline Vec3 mirrored(Vec3 w) { return {w.x, w.y, -w.z}; }

// The centres of cells that divide the hemisphere into equal solid angles.
inline std::vector<Vec3> grid(int heights, int sectors) {
  std::vector<Vec3> directions;
  for (int i = 0; i < heights; ++i) {
    for (int j = 0; j < sectors; ++j) {
      directions.push_back(at((i + 0.5) / heights, 2 * pt::kPi * (j + 0.5) / sectors));
    }
  }
  return directions;
}

// The battery calls f for wo and wi of these heights: on the same side of the surface, on different
// sides, and close to it.
struct Heights {
  double out, in;
};
inline constexpr Heights kHeightsOfPairs[] = {{.9, .8},   {.3, .9},   {.9, .1},   {.5, .5},
                                              {.5, -.5},  {-.4, .6},  {-.7, -.3}, {-.1, -.9},
                                              {.5, 5e-4}, {5e-4, .5}, {5e-7, .5}};

}  // namespace grader::check::diffuse_bsdf_inputs
