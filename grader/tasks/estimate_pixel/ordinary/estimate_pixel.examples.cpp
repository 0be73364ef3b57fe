// Ordinary inputs: 400 pixels of pictures of any size, each partly or wholly covered by something bright, with 1 to 64 samples, and
// eight calls for each.
#include "pt/tasks/estimate_pixel.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"

#include <algorithm>
#include <cmath>

using namespace pt;
using namespace pt::inputs;

// A pixel, and a bright part of it: from left to right and from bottom to top, as parts of the pixel.
struct Input {
  int width, height, x, y;
  double left, right, bottom, top;
  Rgb radiance;

  double share() const { return (right - left) * (top - bottom); }
  bool has_centre() const { return left < 0.5 && right > 0.5 && bottom < 0.5 && top > 0.5; }
};

static Input any_input(Sampler& sampler, int kind) {
  const auto number = [&](int most) { return static_cast<int>(any_number(sampler, 0, most)); };
  Input input{1 + number(7), 1 + number(7), 0, 0, 0, 1, 0, 1, any_color(sampler)};
  input.x = number(input.width);
  input.y = number(input.height);
  input.radiance = std::pow(10, any_number(sampler, -1, 2)) * input.radiance;
  if (kind % 4 == 0) return input;
  input.left = any_number(sampler, 0, 0.4);
  input.right = any_number(sampler, 0.6, 1) - 0.3 * (kind % 3);
  input.bottom = any_number(sampler, 0, 0.4);
  input.top = any_number(sampler, 0.6, 1);
  input.right = std::max(input.right, input.left + 0.1);
  return input;
}

// The camera sees -1 .. 1 along both axes.
static View view_of(const Input& input, const Scene& scene, bool normals) {
  View view = scenes::view_of(scene);
  view.width = input.width;
  view.height = input.height;
  view.settings.show_normals = normals;
  return view;
}

static Scene scene_of(const Input& input) {
  const auto across = [&](double at) { return -1 + 2 * (input.x + at) / input.width; };
  const auto up = [&](double at) { return -1 + 2 * (input.y + at) / input.height; };
  return scenes::bright(across(input.left), across(input.right), up(input.bottom), up(input.top),
                        input.radiance);
}

static bool is_right(const Input& input, int samples, bool normals, Sampler& sampler) {
  const Scene scene = scene_of(input);
  const View view = view_of(input, scene, normals);
  const Rgb color = normals ? Rgb{0.5, 0.5, 1} : input.radiance;
  const double share = samples > 1 ? input.share() : input.has_centre() ? 1 : 0;
  constexpr int kCalls = 8;
  Rgb sum;
  for (int i = 0; i < kCalls; ++i) {
    const Sampler::State before = sampler.state();
    sum = sum + estimate_pixel(view, input.x, input.y, samples, sampler);
    if (samples > 1 && sampler.state() == before) return false;
  }
  const Rgb difference = (1.0 / kCalls) * sum - share * color;
  const double noise = samples > 1 ? std::sqrt(share * (1 - share) / (kCalls * samples)) : 0;
  const double most = (5 * noise + 1e-4) * std::max({color.r, color.g, color.b});
  return std::abs(difference.r) <= most && std::abs(difference.g) <= most &&
         std::abs(difference.b) <= most;
}

EXAMPLE("less than 1 in 100 ordinary pixels differs") {
  Sampler sampler(1);
  int differ = 0;
  constexpr int kInputs = 400;
  for (int i = 0; i < kInputs; ++i) {
    const Input input = any_input(sampler, i);
    const int samples = i % 5 == 0 ? 1 : static_cast<int>(any_number(sampler, 2, 65));
    if (!is_right(input, samples, i % 9 == 0, sampler)) ++differ;
  }
  EXPECT(differ < kInputs / 100);
}

// Of a small bright part of the pixel, so that the points have to be anywhere.
EXAMPLE("all parts of a pixel are equally likely") {
  Sampler sampler(2);
  constexpr int kCalls = 500;
  for (int i = 0; i < 16; ++i) {
    const double left = 0.25 * (i % 4), bottom = 0.25 * (i / 4);
    const Input input{1, 1, 0, 0, left, left + 0.25, bottom, bottom + 0.25, {1, 1, 1}};
    const Scene scene = scene_of(input);
    const View view = view_of(input, scene, false);
    double sum = 0;
    for (int k = 0; k < kCalls; ++k) sum += estimate_pixel(view, 0, 0, 16, sampler).g;
    NEAR(sum / kCalls, 1.0 / 16, 5 * std::sqrt(1.0 / 16 / (16 * kCalls)));
  }
}
