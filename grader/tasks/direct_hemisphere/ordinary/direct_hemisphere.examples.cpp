// Ordinary inputs: 200 floors in every orientation, seen from their front or their back, some of which shine themselves. Above them is a
// lamp, a white sky with something dark in it, a lamp behind a screen, or a lamp that is turned away. Each is estimated with 8 calls of
// 1 to 256 samples.
#include "pt/tasks/direct_hemisphere.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"

#include <cmath>

using namespace pt;
using namespace pt::inputs;

struct Input {
  Scene scene;
  SurfacePoint point;
  Rgb expected;
  double most;  // of one sample, for the channel g
};

static Input any_input(Sampler& sampler, int kind) {
  const bool under_sky = kind % 5 == 1;
  const Place place = under_sky ? any_place_on_floor(sampler, {0, 1, 0}) : any_place(sampler);
  const double light = std::pow(10, any_number(sampler, -1, 2));
  Material floor{"floor", any_color(sampler), {}, ""};
  floor.albedo.g = any_number(sampler, 0.2, 1);
  if (kind % 3 == 0) floor.emission = {2, 2, 2};
  const Material lamp{"lamp", any_color(sampler), gray(light), ""}, dark{"dark", {}, {}, ""};
  double share = scenes::share_of_sky(place.p, place.n, place.center, place.u, place.v);
  Scene scene;
  if (under_sky) {  // beside something dark
    scene.lights = {AmbientLight{gray(light)}};
    scene = scenes::with_rectangle(scene, place.center, place.u, place.v, dark);
    share = 1 - share;
  } else if (kind % 5 == 2) {  // the lamp is turned away
    scene = scenes::with_rectangle(scene, place.center, place.v, place.u, lamp);
    share = 0;
  } else {
    scene = scenes::with_rectangle(scene, place.center, place.u, place.v, lamp);
  }
  if (kind % 5 == 3) {
    const Vec3 middle = place.p + 0.5 * (place.center - place.p);
    const bool front = kind % 2 == 0;
    scene = scenes::with_screen(scene, middle, 0.7 * (front ? place.u : place.v),
                                0.7 * (front ? place.v : place.u));
    share = 0;
  }
  scene = with_floor(scene, place, kind % 4 == 0, floor);
  const SurfacePoint point = point_of(scene, place);
  return {scene, point, (light * share) * floor.albedo, 2 * light * floor.albedo.g};
}

// The second moment of one sample is at most `most` times the mean.
static double noise(const Input& input, int samples) {
  return std::sqrt(input.most * input.expected.g / samples);
}

EXAMPLE("less than 1 in 100 ordinary inputs differs, and their mean is right") {
  Sampler sampler(1);
  int differ = 0;
  double sum = 0, expected = 0, variance = 0;
  constexpr int kInputs = 200, kCalls = 8;
  for (int i = 0; i < kInputs; ++i) {
    const Input input = any_input(sampler, i);
    const int samples = 1 << (i % 9);
    Rgb mean;
    for (int k = 0; k < kCalls; ++k)
      mean = mean + (1.0 / kCalls) * direct_hemisphere(input.scene, input.point, samples, sampler);
    const double most = 5 * noise(input, samples * kCalls) + 1e-4 * input.expected.g;
    // The light is white: each channel differs by the albedo.
    const double red = mean.r * input.expected.g - mean.g * input.expected.r;
    const double blue = mean.b * input.expected.g - mean.g * input.expected.b;
    const bool is_right = std::abs(mean.g - input.expected.g) <= most &&
                          std::abs(red) + std::abs(blue) <= 1e-4 * input.most * input.most;
    if (!is_right) ++differ;
    sum += mean.g / input.most;
    expected += input.expected.g / input.most;
    variance += std::pow(noise(input, samples * kCalls) / input.most, 2);
  }
  EXPECT(differ < kInputs / 100);
  NEAR(sum, expected, 5 * std::sqrt(variance));
}

// Under a white sky a sample is 2 cos times the albedo. Its variance is a third of the square of the albedo.
EXAMPLE("the noise under a white sky falls with the number of samples") {
  Sampler sampler(1);
  const Scene scene = scenes::floor_under_sky();
  const SurfacePoint point = scenes::middle_of_floor(scene);
  constexpr int kCalls = 1500;
  for (const int samples : {1, 4, 32}) {
    double sum = 0, squares = 0, before = 0;
    int equal = 0;
    for (int k = 0; k < kCalls; ++k) {
      const double difference =
          direct_hemisphere(scene, point, samples, sampler).r / scenes::kBrown.r - 1;
      sum += difference;
      squares += difference * difference;
      equal += difference == before ? 1 : 0;
      before = difference;
    }
    const double variance = 1.0 / 3 / samples;
    NEAR(sum / kCalls, 0, 5 * std::sqrt(variance / kCalls));
    EXPECT(squares / kCalls < 1.2 * variance);
    EXPECT(equal < kCalls / 100);
  }
}

EXAMPLE("the same numbers give the same estimate") {
  const Scene scene = scenes::floor_under_lamp();
  const SurfacePoint point = scenes::middle_of_floor(scene);
  EXPECT(repeats([&](Sampler& sampler) { return direct_hemisphere(scene, point, 16, sampler); }));
}
