#include "grader/check/curve.h"
#include "grader/check/generators.h"
#include "grader/check/property.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <algorithm>
#include <cmath>

namespace grader::check {
namespace {

pt::Vec3 above_the_surface(double height) {
  const double phi = *real(-pt::kPi, pt::kPi), r = std::sqrt((1 - height) * (1 + height));
  return {r * std::cos(phi), r * std::sin(phi), height};
}

// Below this cosine the contract promises nothing.
constexpr double kSmallestCosine = 1e-100;

CURVE(diffuse_bsdf, grazing) {
  return {.title = "Light that comes and goes almost in the plane of the surface",
          .input = "cosine of both directions with the normal",
          .error = "relative error of f",
          .source = "a limit for the cosine; the product of two cosines is 0 below 1e-162",
          .places = by_factors(1, 1e-200, 21),
          .promised = {{kSmallestCosine, 1, at_most(kColorPrecision)}},
          .methods = {{"right/in_float", "single precision"},
                      {"wrong/grazing_eye_dropped", "cosines below a millionth dropped"}},
          .measure = [](double cosine) {
            const double albedo = *real(0.1, 1);
            const pt::Vec3 wo = above_the_surface(cosine), wi = above_the_surface(cosine);
            const pt::Rgb f = pt::diffuse_f(pt::gray(albedo), wo, wi);
            return std::abs(f.r * pt::kPi / albedo - 1);
          }};
}

}  // namespace
}  // namespace grader::check
