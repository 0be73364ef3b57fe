#include "measure/calls/exact.h"
#include "pt/tasks/hit_box.h"

namespace measure::calls {

namespace {

using pt::Vec3;

constexpr std::uint64_t kSeed = 22;
constexpr long double kMargin = 1e-6L;  // of the largest length: no edges

// An end of the part of the ray in the box, and the ray's speed through the plane at this end.
struct End {
  long double t = 0;
  long double speed = 0;
};

struct Ends {
  End enter, leave;
};

struct Input {
  pt::Box box;
  pt::Ray ray;
  Ends ends;
  long double largest = 0;  // coordinate

  bool hits() const { return ends.enter.t <= ends.leave.t; }
};

// Returns where the ray enters and leaves, by slabs (Kay and Kajiya 1986), in long double; nothing if the ray runs beside the box.
std::optional<Ends> find_ends(const pt::Box& box, const pt::Ray& ray) {
  const long double step = length(Precise3(ray.direction));
  Ends ends{{ray.t_min, step}, {ray.t_max, step}};
  for (int axis = 0; axis < 3; ++axis) {
    const long double o = ray.origin[axis], d = ray.direction[axis];
    const long double low = box.min[axis], high = box.max[axis];
    if (d == 0) {
      if (o < low || o > high) return {};
      continue;
    }
    const long double t0 = ((d > 0 ? low : high) - o) / d, t1 = ((d > 0 ? high : low) - o) / d;
    if (t0 > ends.enter.t) ends.enter = {t0, std::abs(d)};
    if (t1 < ends.leave.t) ends.leave = {t1, std::abs(d)};
  }
  return ends;
}

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
  input.largest =
      std::max({max_abs(input.box.min), max_abs(input.box.max), max_abs(input.ray.origin)});
  if (!(length(input.ray.direction) > 0)) return {};
  const std::optional<Ends> ends = find_ends(input.box, input.ray);
  if (!ends) {
    input.ends.leave.t = -1;
    return input;
  }
  input.ends = *ends;
  const long double step = length(input.ray.direction);
  const long double inside = (ends->leave.t - ends->enter.t) * step;
  if (is_flat ? std::abs(inside) > 0 && inside > -kMargin * input.largest
              : std::abs(inside) < kMargin * input.largest) {
    return {};
  }
  return input;
}

void look(const Input& input, const std::optional<pt::Interval>& answer, Found& found) {
  if (answer.has_value() != input.hits()) ++found.wrong;
  if (!answer || !input.hits()) return;
  const auto error = [&](double t, const End& end) {
    return (t - end.t) * end.speed / input.largest;
  };
  keep_largest(found.errors[0], error(answer->min, input.ends.enter));
  keep_largest(found.errors[0], error(answer->max, input.ends.leave));
}

}  // namespace

Subject measure_hit_box(int) {
  return exact_subject(
      make_inputs(kSeed, make_input),
      [](const Input& input) { return pt::hit_box(input.box, input.ray); }, look);
}

}  // namespace measure::calls
