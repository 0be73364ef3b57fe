#include "grader/check/generators/generators.h"
#include "grader/check/language/curve.h"
#include "grader/check/language/property.h"
#include "grader/tasks/diffuse_bsdf/inputs.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace diffuse_bsdf_inputs;

Vec3 at_any_azimuth(double height) { return at(height, *real(-pt::kPi, pt::kPi)); }

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
            const Vec3 wo = at_any_azimuth(cosine), wi = at_any_azimuth(cosine);
            const Rgb f = pt::diffuse_f(pt::gray(albedo), wo, wi);
            return std::abs(f.r * pt::kPi / albedo - 1);
          }};
}

}  // namespace
}  // namespace grader::check
