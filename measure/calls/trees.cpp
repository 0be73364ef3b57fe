#include "measure/calls/trees.h"

#include "measure/calls/exact.h"
#include "pt/scene/recorder.h"
#include "scenes/meshes.h"

#include <algorithm>

namespace measure::calls {

namespace {

using pt::Hit;
using pt::Ray;
using pt::Vec3;

constexpr std::uint64_t kSeed = 21;

void add(pt::Primitives& primitives, const scenes::Mesh& mesh, Vec3 shift) {
  for (pt::Triangle triangle : scenes::to_primitives(mesh).triangles) {
    for (Vec3* corner : {&triangle.p0, &triangle.p1, &triangle.p2}) *corner += shift;
    primitives.triangles.push_back(triangle);
  }
}

std::optional<double> nearest_by_all(const pt::Primitives& primitives, const Ray& ray) {
  std::optional<double> nearest;
  for (int i = 0; i < primitives.size(); ++i) {
    const auto hit = hit_primitive(primitives, i, ray);
    if (hit && !(nearest && *nearest <= hit->t)) nearest = hit->t;
  }
  return nearest;
}

// Some 400 KiB with the tree. It fits in the L2 cache, where other programs disturb it less.
TreeInputs make_inputs() {
  TreeInputs inputs;
  add(inputs.primitives, scenes::make_blob(1500), {-1.2, 0, 0});
  add(inputs.primitives, scenes::make_coil(800), {1.2, 0, 0});
  const Vec3 a{-9, -1.2, -9}, b{-9, -1.2, 9}, c{9, -1.2, 9}, d{9, -1.2, -9};
  inputs.primitives.triangles.push_back(pt::flat_triangle(a, b, c));
  inputs.primitives.triangles.push_back(pt::flat_triangle(a, c, d));
  for (int i = 0; i < inputs.primitives.size(); ++i) {
    inputs.boxes.push_back(bounds(inputs.primitives, i));
  }
  pt::Sampler sampler(kSeed);
  for (int i = 0; i < kRays; ++i) {
    Ray ray;
    ray.origin = i % 2 == 0 ? Vec3{0, 1, 6} : in_cube(2.4, sampler);
    const Vec3 target = in_cube(2.4, sampler);
    ray.direction = normalize(target - ray.origin);
    inputs.rays.push_back(ray);
    ray.t_max = length(target - ray.origin);
    inputs.shadow_rays.push_back(ray);
    inputs.nearest.push_back(nearest_by_all(inputs.primitives, inputs.rays.back()));
    inputs.occluded.push_back(nearest_by_all(inputs.primitives, ray).has_value());
  }
  return inputs;
}

}  // namespace

const TreeInputs& tree_inputs() {
  static const TreeInputs all = make_inputs();
  return all;
}

Found query(const pt::Bvh& bvh, bool any) {
  const TreeInputs& all = tree_inputs();
  Found found;
  const pt::TestCount before = pt::recorder.count;
  for (std::size_t i = 0; i < kRays; ++i) {
    if (any) {
      const bool hit = occluded_bvh(bvh, all.primitives, all.shadow_rays[i]);
      if (hit != all.occluded[i]) ++found.wrong;
    } else {
      const std::optional<Hit> hit = hit_bvh(bvh, all.primitives, all.rays[i]);
      const std::optional<double> t = hit ? std::optional(hit->t) : std::nullopt;
      if (t != all.nearest[i]) ++found.wrong;
    }
  }
  const pt::TestCount after = pt::recorder.count;
  found.wrong /= kRays;
  found.boxes = static_cast<double>(after.boxes - before.boxes) / kRays;
  found.primitives =
      static_cast<double>(after.triangles - before.triangles + after.spheres - before.spheres) /
      kRays;
  return found;
}

}  // namespace measure::calls
