#include "measure/calls/exact.h"
#include "pt/tasks/camera_ray.h"

namespace measure::calls {

namespace {

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

Precise3 true_direction(const Input& input) {
  constexpr long double kHalfDegree = 3.14159265358979323846264338327950288L / 360;
  const pt::Camera& camera = input.camera;
  const long double x = (2 * static_cast<long double>(input.x) - 1) *
                        std::tan(kHalfDegree * static_cast<long double>(camera.hfov_deg));
  const long double y = (2 * static_cast<long double>(input.y) - 1) *
                        std::tan(kHalfDegree * static_cast<long double>(camera.vfov_deg));
  const pt::Frame& frame = camera.camera_to_world;
  return normalize(x * Precise3(frame.x) + y * Precise3(frame.y) - Precise3(frame.z));
}

void look(const Input& input, const pt::Ray& ray, Found& found) {
  keep_largest(found.errors[0], length(Precise3(ray.direction) - true_direction(input)));
  const pt::Vec3 position = input.camera.position;
  keep_largest(found.errors[1], length(Precise3(ray.origin) - position) / length(position));
}

}  // namespace

Subject measure_camera_ray(int) {
  return exact_subject(
      make_inputs(kSeed, make_input),
      [](const Input& input) { return pt::camera_ray(input.camera, input.x, input.y); }, look);
}

}  // namespace measure::calls
