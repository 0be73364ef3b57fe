#include "pt/tasks/estimate_pixel.h"
#include "tests/proof/scenes.h"

#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

// Rendering a pixel allocates no memory, however many rays it takes.

namespace {

thread_local long long allocations = 0;

}  // namespace

// Not inlined: otherwise g++ sees malloc and delete together, and warns that they do not match.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace pt::proof {
namespace {

TEST(Allocation, counts) {
  const long long before = allocations;
  const std::vector<int> one(3);
  EXPECT_EQ(allocations, before + 1) << one.size();
}

TEST(Allocation, is_none_in_a_pixel) {
  for (const Engine engine : {Engine::linear, Engine::task, Engine::wide}) {
    for (const auto direct : {PathSettings::Direct::lights, PathSettings::Direct::hemisphere}) {
      SceneBuilder builder;
      builder.room({-1, -1, -1}, {1, 1, 1}, builder.material({0.7, 0.6, 0.5}));
      builder.sphere({-0.4, -0.5, -0.3}, 0.4, builder.material({0.3, 0.5, 0.7}));
      builder.light(RectangleLight{{0, 0.9, 0}, {0.8, 0, 0}, {0, 0, 0.8}, {0, -1, 0}, gray(5)});
      builder.light(SphereLight{{0.6, 0.2, -0.6}, 0.1, gray(8)});
      const Scene scene = builder.finish(engine);
      View view{scene, {}, {}, 8, 6};
      view.camera.position = {0, 0, 0.9};
      view.settings.direct = direct;
      view.settings.light_samples = 20;
      view.settings.to = 4;
      const RayCount rays_before = rays_traced();
      const long long before = allocations;
      for (int pixel = 0; pixel < 48; ++pixel) {
        Sampler sampler = Sampler::for_pixel(7, pixel % 8, pixel / 8);
        estimate_pixel(view, pixel % 8, pixel / 8, 8, sampler);
      }
      EXPECT_EQ(allocations, before);
      EXPECT_GT(rays_traced().closest, rays_before.closest + 48 * 8);
    }
  }
}

}  // namespace
}  // namespace pt::proof
