#include "pt/scene/light.h"

#include "pt/math/frame.h"
#include "pt/sampling/directions.h"
#include "pt/scene/recorder.h"

#include <algorithm>
#include <cmath>

namespace pt {

namespace {

// A point q on an emitting surface with normal n, chosen with density 1 / area. The density per
// steradian follows from the solid angle of a piece dA of the surface: cos(light) dA / distance^2.
LightSample area_sample(Vec3 p, Vec3 q, Vec3 n, double area, Rgb radiance) {
  const Vec3 to_light = q - p;
  const double squared = length_squared(to_light);
  if (!(squared > 0)) return {n, 0, {}, 1, false};
  const double distance = std::sqrt(squared);
  const Vec3 wi = to_light / distance;
  const double cos_light = -dot(wi, n);
  if (!(cos_light > 0)) return {wi, distance, {}, 1, false};
  return {wi, distance, radiance, squared / (cos_light * area), false};
}

LightSample sample(const RectangleLight& light, Vec3 p, Sampler& sampler) {
  const Vec2 xi = sampler.next_2d();
  const Vec3 q = light.center + (xi.x - 0.5) * light.u + (xi.y - 0.5) * light.v;
  LightSample one = area_sample(p, q, light.n, length(cross(light.u, light.v)), light.radiance);
  if (light.as_in_cs184 && !is_black(one.radiance)) one.pdf /= one.distance;
  return one;
}

// Seen from outside, a sphere fills a cone of directions, and all of it emits towards p. So a
// uniform direction in the cone has no noise except from shadows.
LightSample sample(const SphereLight& light, Vec3 p, Sampler& sampler) {
  const Vec2 xi = sampler.next_2d();
  const Vec3 to_center = light.center - p;
  const double center_distance = length(to_center);
  const double sine = light.radius / center_distance;
  // Inside it is dark. A point of the sphere itself is inside, whatever the rounding errors of p and of the centre.
  const double doubt = 1e-9 + 1e-14 * (max_abs(p) + max_abs(light.center)) / light.radius;
  if (!(sine < 1 - doubt)) return {{0, 0, 1}, 0, {}, 1, false};
  // 1 - cos = sin^2 / (1 + cos) keeps its digits however small the sphere looks.
  const double one_minus_cos = sine * sine / (1 + std::sqrt(1 - sine * sine));
  const Vec3 local = uniform_cone(xi, one_minus_cos);
  const Vec3 wi = frame_from_normal(to_center / center_distance).to_world(local);
  // The distance of the ray from the centre. In a narrow cone, 1 - z^2 would lose its digits.
  const double side = center_distance * std::sqrt(local.x * local.x + local.y * local.y);
  const double half_chord = std::sqrt(std::max(0.0, light.radius * light.radius - side * side));
  const double distance = center_distance * local.z - half_chord;
  return {wi, distance, light.radiance, 1 / (2 * kPi * one_minus_cos), false};
}

LightSample sample(const MeshLight& light, Vec3 p, Sampler& sampler) {
  const double area = light.area_up_to.empty() ? 0 : light.area_up_to.back();
  if (!(area > 0)) return {{0, 0, 1}, 0, {}, 1, false};
  const double position = sampler.next_1d() * area;
  const Vec2 xi = sampler.next_2d();
  const auto found =
      std::upper_bound(light.area_up_to.begin(), light.area_up_to.end() - 1, position);
  const MeshLight::Face& face = light.faces[found - light.area_up_to.begin()];
  // The square root turns the uniform square into a uniform triangle.
  const double r = std::sqrt(xi.x);
  const Vec3 q = (1 - r) * face.p0 + r * (1 - xi.y) * face.p1 + r * xi.y * face.p2;
  const Vec3 n = normalize(cross(face.p1 - face.p0, face.p2 - face.p0));
  return area_sample(p, q, n, area, light.radiance);
}

LightSample sample(const PointLight& light, Vec3 p, Sampler&) {
  const Vec3 to_light = light.position - p;
  const double squared = length_squared(to_light);
  if (!(squared > 0)) return {{0, 0, 1}, 0, {}, 1, true};
  const double distance = std::sqrt(squared);
  return {to_light / distance, distance, light.intensity / squared, 1, true};
}

LightSample sample(const DirectionalLight& light, Vec3, Sampler&) {
  return {-light.direction, kInfinity, light.irradiance, 1, true};
}

LightSample sample(const AmbientLight& light, Vec3, Sampler& sampler) {
  static constexpr Frame kUp{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};  // z of the frame is world y
  const Vec3 wi = kUp.to_world(uniform_hemisphere(sampler.next_2d()));
  return {wi, kInfinity, light.radiance, 1 / (2 * kPi), false};
}

// Draws one sample at a time. A light has one radiance, or is black on its dark side.
template <class Kind>
void sample_group(const Kind& light, Vec3 p, int count, Sampler& sampler,
                  LightSampleGroup& samples) {
  samples.radiance = {};
  for (int i = 0; i < count; ++i) {
    const LightSample one = sample(light, p, sampler);
    for (int axis = 0; axis < 3; ++axis) samples.wi[axis][i] = one.wi[axis];
    samples.distance[i] = one.distance;
    samples.pdf[i] = one.pdf;
    samples.is_lit[i] = !is_black(one.radiance);
    if (samples.is_lit[i]) samples.radiance = one.radiance;
  }
}

// The points of a rectangle that samples go to, as fractions of its sides, and their samples by
// area_sample.
struct RectangleSamples {
  double a[kLightGroup], b[kLightGroup];
  double squared[kLightGroup], cos_light[kLightGroup];
};

// Four samples of area_sample side by side, operation for operation.
[[gnu::always_inline]] inline void sample_four(const RectangleLight& light, Vec3 p, double area,
                                               int first, RectangleSamples& from,
                                               LightSampleGroup& samples) {
  const Vec3 c = light.center, u = light.u, v = light.v, n = light.n;
  auto& [x, y, z] = samples.wi;
  for (int i = first; i < first + 4; ++i) {
    const double to_x = c.x + from.a[i] * u.x + from.b[i] * v.x - p.x;
    const double to_y = c.y + from.a[i] * u.y + from.b[i] * v.y - p.y;
    const double to_z = c.z + from.a[i] * u.z + from.b[i] * v.z - p.z;
    from.squared[i] = to_x * to_x + to_y * to_y + to_z * to_z;
    const double distance = std::sqrt(from.squared[i]);
    x[i] = to_x / distance;
    y[i] = to_y / distance;
    z[i] = to_z / distance;
    samples.distance[i] = distance;
    from.cos_light[i] = -(x[i] * n.x + y[i] * n.y + z[i] * n.z);
    samples.pdf[i] = from.squared[i] / (from.cos_light[i] * area);
  }
}

#if defined(__x86_64__)
// The same for machines with wider registers. Multiplications and additions must not be fused.
[[gnu::target("avx2")]] void sample_four_wide(const RectangleLight& light, Vec3 p, double area,
                                              int first, RectangleSamples& from,
                                              LightSampleGroup& samples) {
  sample_four(light, p, area, first, from, samples);
}
const bool has_wide_registers = __builtin_cpu_supports("avx2");
#endif

void sample_group(const RectangleLight& light, Vec3 p, int count, Sampler& sampler,
                  LightSampleGroup& samples) {
  RectangleSamples from;
  for (int i = 0; i < count; ++i) {
    const Vec2 xi = sampler.next_2d();
    from.a[i] = xi.x - 0.5;
    from.b[i] = xi.y - 0.5;
  }
  const double area = length(cross(light.u, light.v));
  for (int first = 0; first < count; first += 4) {
    for (int i = count; i < first + 4; ++i) from.a[i] = from.b[i] = 0;
#if defined(__x86_64__)
    if (has_wide_registers) {
      sample_four_wide(light, p, area, first, from, samples);
      continue;
    }
#endif
    sample_four(light, p, area, first, from, samples);
  }
  samples.radiance = light.radiance;
  const bool shines = !is_black(light.radiance);
  for (int i = 0; i < count; ++i) {
    samples.is_lit[i] = shines & (from.squared[i] > 0) & (from.cos_light[i] > 0);
    if (light.as_in_cs184 && samples.is_lit[i]) samples.pdf[i] /= samples.distance[i];
  }
}

}  // namespace

MeshLight make_mesh_light(const std::vector<MeshLight::Face>& faces, Rgb radiance) {
  MeshLight light{{}, {}, radiance};
  double area = 0;
  for (const MeshLight::Face& face : faces) {
    const double face_area = 0.5 * length(cross(face.p1 - face.p0, face.p2 - face.p0));
    if (!(face_area > 0)) continue;
    area += face_area;
    light.faces.push_back(face);
    light.area_up_to.push_back(area);
  }
  return light;
}

LightSample sample_light(const Light& light, Vec3 p, Sampler& sampler) {
  return keep_call(
      "sample_light",
      [&] { return std::visit([&](const auto& kind) { return sample(kind, p, sampler); }, light); },
      &light, p, sampler);
}

void sample_light_group(const Light& light, Vec3 p, int count, Sampler& sampler,
                        LightSampleGroup& samples) {
  std::visit([&](const auto& kind) { sample_group(kind, p, count, sampler, samples); }, light);
}

}  // namespace pt
