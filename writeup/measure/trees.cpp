#include "pt/render/test_count.h"
#include "pt/tasks/build_bvh.h"
#include "pt/tasks/hit_bvh.h"
#include "scenes/meshes.h"
#include "writeup/measure/draw.h"
#include "writeup/measure/exact.h"

#include <algorithm>
#include <array>

namespace writeup::measure {

namespace {

using pt::Hit;
using pt::Ray;
using pt::Vec3;

constexpr int kRays = 512;
constexpr int kLeaf = 4;  // of hit_bvh's tree, as ./run render has it
constexpr std::array kLeaves{1, 2, 4, 8, 16};
constexpr std::uint64_t kSeed = 21;

struct TreeInputs {
  pt::Primitives primitives;
  std::vector<pt::Box> boxes;
  std::vector<Ray> rays;                       // half from a camera, half from anywhere
  std::vector<Ray> shadow_rays;                // from the same places, each to a point
  std::vector<std::optional<double>> nearest;  // t, by testing every primitive
  std::vector<bool> occluded;
};

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

// Some 400 KiB with the tree: it stays in the second cache, where other programs disturb it less.
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

const TreeInputs& inputs() {
  static const TreeInputs all = make_inputs();
  return all;
}

// Sends the rays through the tree; `any`: the shadow rays, of which any hit will do.
Found query(const pt::Bvh& bvh, bool any) {
  const TreeInputs& all = inputs();
  Found found;
  const pt::TestCount before = pt::test_count;
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
  const pt::TestCount after = pt::test_count;
  found.wrong /= kRays;
  found.boxes = static_cast<double>(after.boxes - before.boxes) / kRays;
  found.primitives =
      static_cast<double>(after.triangles - before.triangles + after.spheres - before.spheres) /
      kRays;
  return found;
}

}  // namespace

Subject tree_builds(int of_cases) {
  const int leaf = kLeaves.at(of_cases);
  return {1,
          [leaf] { sink = static_cast<double>(pt::build_bvh(inputs().boxes, leaf).nodes.size()); },
          [leaf](std::uint64_t) { return query(pt::build_bvh(inputs().boxes, leaf), false); }};
}

Subject tree_queries(int of_cases) {
  const bool any = of_cases == 1;
  const auto bvh = std::make_shared<const pt::Bvh>(pt::build_bvh(inputs().boxes, kLeaf));
  const auto pass = [bvh, any] {
    const TreeInputs& all = inputs();
    double sum = 0;
    for (std::size_t i = 0; i < kRays; ++i) {
      sum += any ? occluded_bvh(*bvh, all.primitives, all.shadow_rays[i])
                 : hit_bvh(*bvh, all.primitives, all.rays[i]).has_value();
    }
    sink = sum;
  };
  return {kRays, pass, [bvh, any](std::uint64_t) { return query(*bvh, any); }};
}

}  // namespace writeup::measure
