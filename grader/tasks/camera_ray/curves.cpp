#include "grader/check/language/curve.h"
#include "grader/check/language/property.h"
#include "grader/tasks/camera_ray/inputs.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace camera_ray_inputs;

// The distance from a random point of the picture to where its ray meets the window, in widths of the
// window, which is from -half to half.
double off_the_window(double half, const pt::Frame& turn) {
  pt::Camera camera;
  camera.hfov_deg = std::atan(half) / radians(0.5);
  camera.vfov_deg = 60;
  camera.camera_to_world = turn;
  const double width = window_of(camera).width;
  const double x = *real(0, 1);
  const pt::Vec3 direction = turn.to_local(call({camera, {x, 0.5}}).direction);
  return std::abs(on_plane(direction).x - (x - 0.5) * width) / width;
}

constexpr double kWidest = 11.43;    // tan(170 degrees / 2)
constexpr double kNarrowest = 1e-5;  // the promises are tested down to a thousandth of a degree

// At the edge of the window, where the contract allows most.
double allowed(double half) { return tolerance(2 * half, {half, 0}) / (2 * half); }

CURVE(camera_ray, wide) {
  return {.title = "A field of view that gets wider, towards 180 degrees",
          .input = "half the width of the window, at distance 1",
          .error = "distance from the right point, in widths of the window",
          .source = "the tangent of an angle close to 90 degrees, where its rounding is all",
          .places = by_factors(0.1, 1e8, 19),
          .promised = {{0.1, kWidest, allowed}},
          .methods = {{"right/single_precision", "single precision"},
                      {"wrong/wide_angles_clamped", "no field of view above 150 degrees"}},
          .measure = [](double half) { return off_the_window(half, {}); }};
}

CURVE(camera_ray, narrow) {
  return {.title = "A field of view that gets narrower, of a camera that is turned",
          .input = "half the width of the window, at distance 1",
          .error = "distance from the right point, in widths of the window",
          .source = "the direction keeps an absolute precision, and its differences do not",
          .places = by_factors(0.1, 1e-12, 23),
          .promised = {{0.1, kNarrowest, allowed}},
          .methods = {{"right/single_precision", "single precision"},
                      {"wrong/narrow_angles_clamped", "no field of view under one degree"}},
          .measure = [](double half) { return off_the_window(half, *rotation()); }};
}

}  // namespace
}  // namespace grader::check
