#include "grader/tasks/camera_ray/truth.h"
#include "measure/calls/exact.h"
#include "pt/tasks/camera_ray.h"

namespace measure::calls {

namespace {

using grader::check::Exact3;
using grader::check::camera_ray_inputs::to_the_window;

constexpr std::uint64_t kSeed = 12;

struct Input {
  pt::Camera camera;
  double x, y;
};

std::optional<Input> make_input(pt::Sampler& sampler) {
  Input input;
  input.camera.position = in_cube(size_between(-3, 3, sampler), sampler);
  const pt::Vec3 back = any_direction(sampler);
  const pt::Vec3 right = normalize(cross(any_direction(sampler), back));
  input.camera.camera_to_world = {right, cross(back, right), back};
  input.camera.hfov_deg = size_between(0, std::log10(170), sampler);
  input.camera.vfov_deg = size_between(0, std::log10(170), sampler);
  input.x = sampler.next_1d();
  input.y = sampler.next_1d();
  return input;
}

void look(const Input& input, const pt::Ray& ray, Found& found) {
  const Exact3 direction = normalize(to_the_window(input.camera, input.x, input.y));
  keep_largest(found.errors[0], length(ray.direction - direction));
  const pt::Vec3 position = input.camera.position;
  keep_largest(found.errors[1], length(ray.origin - Exact3(position)) / length(position));
}

}  // namespace

Subject measure_camera_ray(int) {
  return exact_subject(
      make_inputs(kSeed, make_input),
      [](const Input& input) { return pt::camera_ray(input.camera, input.x, input.y); }, look);
}

}  // namespace measure::calls
