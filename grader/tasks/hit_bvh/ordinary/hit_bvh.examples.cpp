// Ordinary inputs: 1,000 scenes of up to 40 spheres and triangles, with a tree whose leaves have any size, and 20 rays through each
// of them, with every kind of range.
#include "pt/tasks/hit_bvh.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"
#include "pt/tasks/build_bvh.h"

using namespace pt;
using namespace pt::inputs;

// The answer by testing every primitive.
static std::optional<Hit> expected(const Primitives& primitives, const Ray& ray) {
  std::optional<Hit> nearest;
  for (int i = 0; i < primitives.size(); ++i) {
    const auto hit = hit_primitive(primitives, i, ray);
    if (hit && (!nearest || hit->t < nearest->t)) nearest = {hit->t, hit->n, i};
  }
  return nearest;
}

static bool agree(const std::optional<Hit>& a, const std::optional<Hit>& b) {
  if (!a || !b) return !a && !b;
  return a->t == b->t && a->primitive == b->primitive && a->n == b->n;
}

static Primitives any_primitives(Sampler& sampler) {
  Primitives primitives;
  for (int i = static_cast<int>(any_number(sampler, 0, 20)); i > 0; --i) {
    const Vec3 a = 3 * any_vector(sampler), b = a + 2 * any_vector(sampler);
    primitives.triangles.push_back(flat_triangle(a, b, a + 2 * any_vector(sampler)));
  }
  for (int i = static_cast<int>(any_number(sampler, 0, 20)); i > 0; --i)
    primitives.spheres.push_back({3 * any_vector(sampler), any_number(sampler, 0.2, 0.8)});
  return primitives;
}

EXAMPLE("less than 1 in 100 ordinary inputs differs") {
  Sampler sampler(1);
  int differ = 0;
  constexpr int kScenes = 1000, kRays = 20;
  for (int i = 0; i < kScenes; ++i) {
    const Primitives primitives = any_primitives(sampler);
    std::vector<Box> boxes;
    for (int k = 0; k < primitives.size(); ++k) boxes.push_back(bounds(primitives, k));
    const Bvh bvh = build_bvh(boxes, i % 7 == 0 ? 100 : 1 + i % 6);
    for (int k = 0; k < kRays; ++k) {
      Ray ray;
      ray.origin = 5 * any_vector(sampler);
      ray.direction = normalize(3 * any_vector(sampler) - ray.origin);
      if (k % 3 == 0) ray.t_max = any_number(sampler, 0, 8);
      if (k % 4 == 0) ray.t_min = any_number(sampler, 0, 4);
      const auto nearest = expected(primitives, ray);
      const bool same = agree(hit_bvh(bvh, primitives, ray), nearest) &&
                        occluded_bvh(bvh, primitives, ray) == nearest.has_value();
      if (!same) ++differ;
    }
  }
  EXPECT(differ < kScenes * kRays / 100);
}
