// Ordinary inputs: 300 pixels of which a part is bright and the rest is black or has another colour, with batches of 8 to 64 samples,
// tolerances from 0.03 to 0.5 and a maximum of 64 to 2,000 samples, and four calls for each.
#include "pt/tasks/adaptive_pixel.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"

#include <algorithm>
#include <cmath>

using namespace pt;
using namespace pt::inputs;

// A pixel of a picture of 4 by 2, whose left part shines, and whose right part may shine too.
struct Input {
  int x, y;
  double part;  // the width of the left part
  Rgb left, right;
  AdaptiveSettings settings;
};

static Scene scene_of(const Input& input) {
  const double from = -1 + 0.5 * input.x, bottom = -1.0 + input.y;
  const double middle = from + 0.5 * input.part, to = from + 0.5;
  Scene scene = scenes::bright(from, middle, bottom, bottom + 1, input.left);
  if (input.part == 1 || luminance(input.right) == 0) return scene;
  return scenes::with_rectangle(scene, {(middle + to) / 2, bottom + 0.5, -1}, {to - middle, 0, 0},
                                {0, 1, 0}, {"right", {}, input.right, ""});
}

static Input any_input(Sampler& sampler, int kind) {
  const auto number = [&](int least, int most) {
    return static_cast<int>(any_number(sampler, least, most + 1));
  };
  Input input{number(0, 3), number(0, 1), any_number(sampler, 0.2, 0.8), {}, {}, {}};
  const double scale = std::pow(10, any_number(sampler, -1, 2));
  input.left = scale * (any_color(sampler) + gray(0.1));
  if (kind % 3 == 0) input.right = {scale * sampler.next_1d(), 0.3 * input.left.g, 0};
  if (kind % 5 == 0) input.part = 1;
  input.settings.batch = number(8, 64);
  input.settings.max_samples =
      number(std::max(64, input.settings.batch), kind % 4 == 0 ? 100 : 2000);
  input.settings.tolerance = std::pow(10, any_number(sampler, -1.5, -0.3));
  return input;
}

// The number of n samples on the left, by one channel of the mean. `fits` says whether this is a whole number.
struct Left {
  double count;
  bool fits;
};

static Left left_of(const Input& input, const PixelEstimate& estimate) {
  const double n = estimate.samples, left = input.left.g, right = input.right.g;
  const double count = n * (estimate.mean.g - right) / (left - right);
  return {count, std::abs(count - std::round(count)) < 0.1};
}

// True if the interval is narrow when so many of n samples are on the left. Close to the limit both are right: `slack` is 1 or -1.
static bool is_narrow(const Input& input, double count, double n, int slack) {
  const double a = luminance(input.left), b = luminance(input.right), p = count / n;
  const double mean = p * a + (1 - p) * b;
  const double sigma = std::abs(a - b) * std::sqrt(std::max(0.0, p * (1 - p)));
  return 1.96 * sigma / std::sqrt(n) < input.settings.tolerance * mean * (1 + slack * 0.1);
}

static bool is_right(const Input& input, const Scene& scene, Sampler& sampler) {
  const AdaptiveSettings& settings = input.settings;
  const Sampler::State before = sampler.state();
  const PixelEstimate estimate =
      adaptive_pixel(scenes::view_of(scene), input.x, input.y, settings, sampler);
  const int n = estimate.samples;
  if (sampler.state() == before) return false;
  if (n < 1 || n > settings.max_samples) return false;
  if (n != settings.max_samples && n % settings.batch != 0) return false;
  if (input.part == 1)
    return n == settings.batch && std::abs(estimate.mean.r - input.left.r) <= 1e-4 * input.left.r;
  const Left left = left_of(input, estimate);
  if (!left.fits) return false;
  const bool is_black = left.count < 0.5 && luminance(input.right) == 0;
  if (n < settings.max_samples && !is_black && !is_narrow(input, left.count, n, 1)) return false;
  const double noise = std::sqrt(input.part * (1 - input.part) / n);
  return std::abs(left.count / n - input.part) <= 6 * noise + 0.02;
}

EXAMPLE("less than 1 in 100 ordinary pixels differs") {
  Sampler sampler(1);
  int differ = 0;
  constexpr int kInputs = 300;
  for (int i = 0; i < kInputs; ++i) {
    const Input input = any_input(sampler, i);
    const Scene scene = scene_of(input);
    bool right = true;
    for (int k = 0; k < 4 && right; ++k) right = is_right(input, scene, sampler);
    if (!right) ++differ;
  }
  EXPECT(differ < kInputs / 100);
}

// Far below the maximum, the number of samples is about that at which the interval is narrow.
EXAMPLE("it takes as many samples as the tolerance needs") {
  Sampler sampler(2);
  double sum = 0, expected = 0;
  for (int i = 0; i < 200; ++i) {
    Input input = any_input(sampler, 3 * i + 1);
    input.part = any_number(sampler, 0.3, 0.7);
    input.settings.max_samples = 20000;
    input.settings.batch = 8;
    input.settings.tolerance = any_number(sampler, 0.1, 0.2);
    input.right = {};
    const Scene scene = scene_of(input);
    const int n =
        adaptive_pixel(scenes::view_of(scene), input.x, input.y, input.settings, sampler).samples;
    const double needed = 1.96 * 1.96 * (1 - input.part) / input.part / input.settings.tolerance /
                          input.settings.tolerance;
    sum += n / needed;
    expected += 1 + 4 / needed;
  }
  NEAR(sum / 200, expected / 200, 0.1);
}

EXAMPLE("all parts of a pixel are equally likely") {
  Sampler sampler(3);
  for (int i = 0; i < 16; ++i) {
    const double left = -1 + 0.125 * (i % 4), bottom = -1 + 0.25 * (i / 4);
    const Scene scene = scenes::bright(left, left + 0.125, bottom, bottom + 0.25);
    const View view = scenes::view_of(scene);
    double sum = 0;
    for (int k = 0; k < 300; ++k) sum += adaptive_pixel(view, 0, 0, {32, 32, 0.1}, sampler).mean.g;
    NEAR(sum / 300, 1.0 / 16, 5 * std::sqrt(1.0 / 16 / 32 / 300));
  }
}

EXAMPLE("the settings of the view") {
  Sampler sampler(4);
  const Scene scene = scenes::bright(-1, 1, -1, 1);
  View view = scenes::view_of(scene);
  view.settings.show_normals = true;
  NEAR(adaptive_pixel(view, 1, 1, {64, 8, 0.1}, sampler).mean, {0.5, 0.5, 1});
}
