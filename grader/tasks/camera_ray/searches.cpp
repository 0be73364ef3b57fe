#include "grader/check/language/bad_inputs.h"
#include "grader/tasks/camera_ray/inputs.h"

namespace grader::check {
namespace {

using namespace camera_ray_inputs;

SEARCH(camera_ray, window) {
  return {.title = "a ray of any camera: how far it meets the window from its point",
          .measure = "1 is what the contract allows",
          .badness = [] {
            const Aimed made = *aimed(moved());
            const pt::Camera& c = made.camera;
            show_case(made);
            const pt::Ray ray = call(made);
            const auto& [right, up, back] = c.camera_to_world;
            const Exact3 d = ray.direction, way = to_the_window(c, made.at.x, made.at.y);
            const Exact3 off = -1 / dot(d, Exact3(back)) * d - way;
            const auto along = [](const Exact3& a, pt::Vec3 b) {
              return rounded(dot(a, Exact3(b)));
            };
            const pt::Vec2 at{along(way, right), along(way, up)};
            const auto [width, height] = window_of(c);
            return std::max({std::abs(along(off, right)) / tolerance(width, at),
                             std::abs(along(off, up)) / tolerance(height, at),
                             std::abs(length(ray.direction) - 1) / kPrecision});
          }};
}

}  // namespace
}  // namespace grader::check
