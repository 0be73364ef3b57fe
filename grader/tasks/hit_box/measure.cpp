#include "grader/tasks/hit_box/truth.h"
#include "measure/calls/exact.h"
#include "pt/tasks/hit_box.h"

namespace measure::calls {

namespace {

using namespace grader::check::hit_box_inputs;
using grader::check::rounded;
using pt::Vec3;

constexpr std::uint64_t kSeed = 22;
constexpr double kNoEdges = 1e-6;  // of the largest length

struct Input {
  pt::Box box;
  pt::Ray ray;
  bool hits = false;
};

// Some rays are along an axis.
Vec3 aim(Vec3 to, pt::Sampler& sampler) {
  if (sampler.next_1d() < 0.125) {
    const int axis = static_cast<int>(3 * sampler.next_1d());
    for (int other = 0; other < 3; ++other) {
      if (other != axis) to[other] = 0;
    }
  }
  return size_between(-3, 3, sampler) * normalize(to);
}

std::optional<Input> make_input(pt::Sampler& sampler) {
  const double size = size_between(-3, 3, sampler);
  Vec3 half;
  for (int axis = 0; axis < 3; ++axis) half[axis] = size * size_between(-2, 0, sampler);
  if (sampler.next_1d() < 0.125) half[static_cast<int>(3 * sampler.next_1d())] = 0;
  const Vec3 center = in_cube(size * size_between(-1, 2, sampler), sampler);
  const auto point = [&](double reach) {
    const Vec3 at = in_cube(reach, sampler);
    return center + Vec3{at.x * half.x, at.y * half.y, at.z * half.z};
  };
  Input input;
  input.box = {center - half, center + half};
  const bool is_flat = half.x * half.y * half.z == 0;
  input.ray.origin = !is_flat && sampler.next_1d() < 0.125
                         ? point(0.9)
                         : center + size * size_between(-0.5, 2, sampler) * any_direction(sampler);
  input.ray.direction = aim(point(1.6) - input.ray.origin, sampler);
  if (!(length(input.ray.direction) > 0)) return {};
  const Part part = expected(input.box, input.ray, 0);
  input.hits = part.is_hit();
  const double inside = rounded(part.leave.low - part.enter.low) * length(input.ray.direction) /
                        size_of(input.box, input.ray);
  if (is_flat ? std::abs(inside) > 0 && inside > -kNoEdges : std::abs(inside) < kNoEdges) return {};
  return input;
}

void look(const Input& input, const std::optional<pt::Interval>& answer, Found& found) {
  if (answer.has_value() != input.hits) ++found.wrong;
  if (!answer || !input.hits) return;
  keep_largest(found.errors[0], kPrecision * off(input.box, input.ray, *answer));
}

}  // namespace

Subject measure_hit_box(int) {
  return exact_subject(
      make_inputs(kSeed, make_input),
      [](const Input& input) { return pt::hit_box(input.box, input.ray); }, look);
}

}  // namespace measure::calls
