// Figures of merit in five scenes, beside two goldens and pictures with other random numbers, made here, and in the product form
// written out here.
#include "measure/scene/options.h"
#include "measure/scene/study.h"

#include <cmath>

#include <gtest/gtest.h>

namespace measure::scene {
namespace {

using Direct = pt::PathSettings::Direct;

constexpr double kErrors = 4.5;     // standard errors
constexpr double kOfWeights = .04;  // of a squared error: the goldens' noise is in its divisor
constexpr int kWidth = 24, kHeight = 18;
constexpr int kPictures = 8, kSamples = 16, kGolden = 512;

struct Scene {
  explicit Scene(const std::string& name) {
    Options options;
    options.scene = FIRSTLIGHT_ROOT "/scenes/" + name + ".dae";
    loaded = load_scene(options);
  }
  pt::View view() const {
    return {loaded.scene,
            frame_camera(loaded, pt::Framing::course, kWidth, kHeight),
            {},
            kWidth,
            kHeight};
  }

  pt::LoadedScene loaded;
};

// The square of the error of the settings, by pictures of all pixels; the standard error comes from the pictures alone.
Uncertain brute_force(pt::View view, const pt::PathSettings& path,
                      const std::optional<pt::AdaptiveSettings>& adaptive) {
  const std::vector<PixelAt> pixels = spread_pixels(kWidth, kHeight, kWidth * kHeight, 1);
  view.settings = path_of({Direct::lights, path.to}, 1);
  const std::vector<double> a = measure(view, {kGolden, {}, 901, 2}, pixels).mean;
  const std::vector<double> b = measure(view, {kGolden, {}, 902, 2}, pixels).mean;
  double mean = 0;
  for (std::size_t i = 0; i < a.size(); ++i) mean += (a[i] + b[i]) / 2 / double(a.size());
  view.settings = path;
  std::vector<double> squares;
  for (int k = 0; k < kPictures; ++k) {
    const std::vector<double> x = measure(view, {kSamples, adaptive, 911u + k, 2}, pixels).mean;
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum += (x[i] - a[i]) * (x[i] - b[i]) / std::pow((a[i] + b[i]) / 2 + .04 * mean, 2);
    }
    squares.push_back(sum / double(x.size()));
  }
  return mean_of(squares);
}

Uncertain square_of(const Uncertain& error) {
  return {error.value * error.value, 2 * error.value * error.error};
}

void expect_same(const Uncertain& said, const Uncertain& right, const std::string& what) {
  const double slack = kErrors * std::hypot(said.error, right.error) + kOfWeights * right.value;
  EXPECT_NEAR(said.value, right.value, slack) << what;
  EXPECT_LT(said.error, .5 * right.value) << what << ": it would pass with any error";
}

class Merit : public testing::TestWithParam<const char*> {
 protected:
  Uncertain checked(Study& study, const pt::PathSettings& path,
                    const std::optional<pt::AdaptiveSettings>& adaptive,
                    const std::optional<Uncertain>& bias2) {
    return square_of(study.check(path, {kSamples, adaptive, 0, 2}, 1e-9, bias2).error);
  }

  const Scene scene_{GetParam()};
};

// The error that converge has for a number of samples, and the one that cheapest predicts for it.
TEST_P(Merit, errors_of_uniform_sampling_are_those_of_other_pictures) {
  Study study(scene_.view(), 2, 7, {1, 256, kWidth * kHeight}, {}, 3);
  for (const Way& way : {Way{Direct::lights, 3}, Way{Direct::hemisphere, 3}}) {
    const pt::PathSettings path = path_of(way, 2);
    const Uncertain right = brute_force(scene_.view(), path, {});
    const std::string what = way.direct == Direct::lights ? "lights" : "hemisphere";
    expect_same(checked(study, path, {}, Uncertain{}), right, what + ", half squared differences");
    expect_same(checked(study, path, {}, {}), right, what + ", beside the goldens");
    const Uncertain variance = study.try_out(way, {2})[0].variance;
    expect_same({variance.value / kSamples, variance.error / kSamples}, right,
                what + ", predicted");
  }
}

// A tolerance that is met by chance stops a pixel too early.
TEST_P(Merit, the_error_of_adaptive_sampling_is_that_of_other_pictures) {
  Study study(scene_.view(), 2, 8, {1, 256, kWidth * kHeight}, {}, 3);
  const pt::PathSettings path = path_of({Direct::lights, 3}, 1);
  const pt::AdaptiveSettings settings{256, 4, .2};
  const Uncertain right = brute_force(scene_.view(), path, settings);
  expect_same(checked(study, path, settings, {}), right, "adaptive");
}

// The four times as many camera samples, each with four times as many light samples, of part 3.
TEST_P(Merit, four_times_the_samples_at_least_halve_the_error) {
  Study study(scene_.view(), 2, 9, {1, 256, kWidth * kHeight}, {}, 1);
  const auto square = [&](int samples, int light_samples) {
    const pt::PathSettings path = path_of({Direct::lights, 1}, light_samples);
    return square_of(study.check(path, {samples, {}, 0, 2}, 1e-9, Uncertain{}).error);
  };
  const Uncertain few = square(4, 2), many = square(16, 8);
  EXPECT_LT(many.value, few.value / 4 + kErrors * std::hypot(many.error, few.error / 4));
  EXPECT_GT(few.value, 2 * many.value) << "it has hardly any noise";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Merit,
                         testing::Values("box_spheres", "box_blob", "tiny_light", "two_lights",
                                         "penumbra"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace measure::scene
