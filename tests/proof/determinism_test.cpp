#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/estimate_pixel.h"
#include "tests/proof/scenes.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

// The tasks keep nothing between pixels: the same seed gives the same bits, after any other calls,
// in any order and on any thread.

namespace pt::proof {
namespace {

constexpr int kWidth = 24, kHeight = 18;

SceneBuilder room_with_lights() {
  SceneBuilder builder;
  builder.room({-1, -1, -1}, {1, 1, 1}, builder.material({0.7, 0.6, 0.5}));
  builder.sphere({-0.4, -0.5, -0.3}, 0.4, builder.material({0.3, 0.5, 0.7}));
  builder.light(RectangleLight{{0, 0.9, 0}, {0.8, 0, 0}, {0, 0, 0.8}, {0, -1, 0}, gray(5)});
  builder.light(SphereLight{{0.6, 0.2, -0.6}, 0.1, gray(8)});
  return builder;
}

using PixelFunction = Rgb (*)(const View&, int, int, Sampler&);

Rgb estimate(const View& view, int x, int y, Sampler& sampler) {
  return estimate_pixel(view, x, y, 8, sampler);
}

Rgb adaptive(const View& view, int x, int y, Sampler& sampler) {
  const PixelEstimate pixel = adaptive_pixel(view, x, y, {32, 8, 0.1}, sampler);
  return pixel.mean + gray(pixel.samples);
}

// Threads take single pixels in an order that the stride scatters.
std::vector<Rgb> render(const View& view, PixelFunction pixel, int threads, int stride) {
  std::vector<Rgb> image(kWidth * kHeight);
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int i = next++; i < kWidth * kHeight; i = next++) {
      const int index = i * stride % (kWidth * kHeight);
      const int x = index % kWidth, y = index / kWidth;
      Sampler sampler = Sampler::for_pixel(7, x, y);
      image[index] = pixel(view, x, y, sampler);
    }
  };
  std::vector<std::thread> pool;
  for (int i = 0; i < threads; ++i) pool.emplace_back(work);
  for (std::thread& thread : pool) thread.join();
  return image;
}

TEST(Determinism, gives_the_same_bits_on_1_2_and_7_threads) {
  for (const Engine engine : kEngines) {
    for (const auto direct : {PathSettings::Direct::lights, PathSettings::Direct::hemisphere}) {
      const Scene scene = room_with_lights().finish(engine);
      View view{scene, {}, {}, kWidth, kHeight};
      view.camera.position = {0, 0, 0.9};
      view.settings.direct = direct;
      view.settings.to = 4;
      for (const PixelFunction pixel : {estimate, adaptive}) {
        const std::vector<Rgb> one = render(view, pixel, 1, 1);
        EXPECT_EQ(one, render(view, pixel, 1, 5)) << "in another order";
        EXPECT_EQ(one, render(view, pixel, 2, 1));
        EXPECT_EQ(one, render(view, pixel, 7, 11));
      }
    }
  }
}

TEST(Determinism, gives_other_numbers_for_another_seed) {
  const Scene scene = room_with_lights().finish(Engine::task);
  View view{scene, {}, {}, kWidth, kHeight};
  view.camera.position = {0, 0, 0.9};
  Sampler a = Sampler::for_pixel(1, 3, 4), b = Sampler::for_pixel(2, 3, 4);
  EXPECT_NE(estimate(view, 3, 4, a), estimate(view, 3, 4, b));
}

}  // namespace
}  // namespace pt::proof
