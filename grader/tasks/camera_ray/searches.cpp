#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/exact.h"
#include "grader/tasks/camera_ray/inputs.h"
#include "pt/tasks/camera_ray.h"

namespace grader::check {
namespace {

using namespace camera_ray_inputs;

// The tangent of half an angle in degrees, in extended precision.
long double half_size(double degrees) {
  constexpr long double kHalfDegree = 3.14159265358979323846264338327950288L / 360;
  return std::tan(kHalfDegree * degrees);
}

SEARCH(camera_ray, window) {
  return {.title = "a ray of any camera: how far it meets the window from its point",
          .measure = "1 is what the contract allows",
          .badness = [] {
            const Aimed made = *aimed(moved());
            const pt::Camera& c = made.camera;
            const double x = made.at.x, y = made.at.y;
            show_input([&] { return show(c) + "\nx " + show(x) + ", y " + show(y); });
            const pt::Ray ray = pt::camera_ray(c, x, y);
            const Exact3 d = ray.direction;
            const Exact z = -dot(d, Exact3(c.camera_to_world.z));
            const Exact at_x = dot(d, Exact3(c.camera_to_world.x)) / z;
            const Exact at_y = dot(d, Exact3(c.camera_to_world.y)) / z;
            const long double w = half_size(c.hfov_deg), h = half_size(c.vfov_deg);
            const Exact right_x = (2 * Exact(x) - 1) * w, right_y = (2 * Exact(y) - 1) * h;
            const pt::Vec2 at{rounded(right_x), rounded(right_y)};
            const double off_x = std::abs(rounded(at_x - right_x));
            const double off_y = std::abs(rounded(at_y - right_y));
            return std::max({off_x / tolerance(2 * static_cast<double>(w), at),
                             off_y / tolerance(2 * static_cast<double>(h), at),
                             std::abs(length(ray.direction) - 1) / kPrecision});
          }};
}

}  // namespace
}  // namespace grader::check
