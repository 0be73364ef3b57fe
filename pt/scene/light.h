#pragma once

#include "pt/math/rgb.h"
#include "pt/math/vec3.h"
#include "pt/sampling/sampler.h"

#include <variant>
#include <vector>

namespace pt {

// The places light comes from, in world space. If an area light has a surface in the scene, sampling
// the light and hitting the surface find the same light. A light without a surface can only be
// sampled.

// The parallelogram center + (a - 1/2) u + (b - 1/2) v, a and b in [0, 1]; emits on n's side.
struct RectangleLight {
  Vec3 center;
  Vec3 u, v;  // whole sides
  Vec3 n;     // unit, cross(u, v) or its opposite
  Rgb radiance;
  bool as_in_cs184 = false;  // pdf lacks a factor of the distance, as in the course's skeleton
};

// The outside of a sphere.
struct SphereLight {
  Vec3 center;
  double radius = 1;
  Rgb radiance;
};

// Any emissive mesh with one radiance. Each triangle emits on the side of its geometric normal.
struct MeshLight {
  struct Face {
    Vec3 p0, p1, p2;
  };
  std::vector<Face> faces;
  std::vector<double> area_up_to;  // area_up_to[i] is the area of faces 0 .. i
  Rgb radiance;
};

struct PointLight {
  Vec3 position;
  Rgb intensity;  // per steradian; the irradiance falls with the squared distance
};

struct DirectionalLight {
  Vec3 direction;  // unit, the way the light travels
  Rgb irradiance;  // on a surface that faces it
};

// The sky: the same radiance from every direction with y > 0 (the upper half of the world).
struct AmbientLight {
  Rgb radiance;
};

using Light = std::variant<RectangleLight, SphereLight, MeshLight, PointLight, DirectionalLight,
                           AmbientLight>;

// Makes a light of these faces, with their running sums of area. Degenerate faces are left out.
MeshLight make_mesh_light(const std::vector<MeshLight::Face>& faces, Rgb radiance);

// One direction from p towards a light. The light reflected at p along wo is estimated by
//   f(wo, wi) radiance cos(wi, n) / pdf, if nothing stands between.
struct LightSample {
  Vec3 wi;              // unit, world space, from p towards the light
  double distance = 0;  // from p along wi to the light; infinite for the sky and directional lights
  Rgb radiance;         // arriving at p along wi if nothing is in the way; for a delta light the
                        // irradiance on a surface that faces it; black where p is on the dark side
  double pdf = 1;       // of wi, per steradian, always > 0; 1 for a delta light
  bool delta = false;   // the light has this one direction only, so one sample says everything
};

LightSample sample_light(const Light& light, Vec3 p, Sampler& sampler);

// Several samples of one light, in rows: row[i] belongs to sample i.
inline constexpr int kLightGroup = 8;
struct LightSampleGroup {
  double wi[3][kLightGroup];  // x, y, z
  double distance[kLightGroup];
  double pdf[kLightGroup];
  bool is_lit[kLightGroup];  // the radiance is not black
  Rgb radiance;              // of the samples that are lit

  Vec3 wi_of(int i) const { return {wi[0][i], wi[1][i], wi[2][i]}; }
};

// Writes to `samples` what `count` calls of sample_light would return, bit for bit; `count` is at
// most kLightGroup. For a rectangle this takes half as long as the calls.
void sample_light_group(const Light& light, Vec3 p, int count, Sampler& sampler,
                        LightSampleGroup& samples);

// Returns whether all samples of the light towards one point are the same direction.
inline bool is_delta(const Light& light) {
  return std::holds_alternative<PointLight>(light) ||
         std::holds_alternative<DirectionalLight>(light);
}

}  // namespace pt
