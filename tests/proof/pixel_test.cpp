#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/estimate_pixel.h"
#include "tests/proof/statistics.h"

#include <functional>

// estimate_pixel and adaptive_pixel on scripted radiances: this program defines the radiance
// function itself.

namespace pt {

namespace {

// The radiances that the pixel sees, in order, and the arguments of its calls.
struct Script {
  std::function<Rgb(int)> value;  // of sample 0, 1, ...
  std::vector<Vec2> at;           // of each ray in the picture, in pixels
  const Scene* scene = nullptr;
  PathSettings settings;
};

Script script;

constexpr int kWidth = 40, kHeight = 30;

// The camera looks along -z with a right angle in both directions: the window is [-1, 1]^2.
Vec2 pixels(const Ray& ray) {
  const Vec3 d = ray.direction;
  return {(1 - d.x / d.z) / 2 * kWidth, (1 - d.y / d.z) / 2 * kHeight};
}

}  // namespace

Rgb radiance(const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler&) {
  script.scene = &scene;
  script.settings = settings;
  script.at.push_back(pixels(ray));
  return script.value(static_cast<int>(script.at.size()) - 1);
}

namespace proof {
namespace {

class Pixel : public testing::Test {
 protected:
  Pixel() {
    view_.camera.hfov_deg = view_.camera.vfov_deg = 90;
    view_.settings.light_samples = 17;
    view_.settings.to = 23;
  }

  void play(const std::function<Rgb(int)>& value) {
    script = {};
    script.value = value;
  }

  Scene scene_;
  View view_{scene_, {}, {}, kWidth, kHeight};
  Sampler sampler_{92};
};

TEST_F(Pixel, is_the_mean_of_what_comes_back) {
  for (const int n : {1, 2, 7, 64}) {
    play([](int i) { return Rgb{1.0 * i, 2.0 * i + 1, i % 2 == 0 ? 4.0 : 0.0}; });
    const Rgb mean = estimate_pixel(view_, 3, 4, n, sampler_);
    EXPECT_EQ(script.at.size(), n);
    EXPECT_EQ(mean, (Rgb{(n - 1) / 2.0, n + 0.0, 4.0 * ((n + 1) / 2) / n}));
    EXPECT_EQ(script.scene, &scene_);
    EXPECT_EQ(script.settings.light_samples, 17);
    EXPECT_EQ(script.settings.to, 23);
  }
}

TEST_F(Pixel, sends_one_sample_through_the_centre) {
  play([](int) { return Rgb{}; });
  for (const int x : {0, 7, kWidth - 1}) {
    for (const int y : {0, 11, kHeight - 1}) {
      estimate_pixel(view_, x, y, 1, sampler_);
      EXPECT_NEAR(script.at.back().x, x + 0.5, 1e-12);
      EXPECT_NEAR(script.at.back().y, y + 0.5, 1e-12);
    }
  }
}

void expect_even(int x, int y, const std::string& what) {
  constexpr int kBins = 12;
  std::vector<double> counts(kBins * kBins);
  for (const Vec2 at : script.at) {
    ASSERT_TRUE(at.x > x - 1e-12 && at.x < x + 1 + 1e-12) << what;
    ASSERT_TRUE(at.y > y - 1e-12 && at.y < y + 1 + 1e-12) << what;
    const auto bin = [](double inside) {
      return std::clamp(static_cast<int>(inside * kBins), 0, kBins - 1);
    };
    ++counts[bin(at.x - x) * kBins + bin(at.y - y)];
  }
  const auto total = static_cast<double>(script.at.size());
  expect_counts(counts, std::vector<double>(counts.size(), total / (kBins * kBins)), what);
}

TEST_F(Pixel, is_covered_evenly) {
  play([](int) { return Rgb{}; });
  estimate_pixel(view_, 39, 2, 100000, sampler_);
  expect_even(39, 2, "estimate_pixel");
  play([](int) { return Rgb{}; });
  for (int i = 0; i < 1000; ++i) adaptive_pixel(view_, 12, 29, {100, 50, 0.05}, sampler_);
  expect_even(12, 29, "adaptive_pixel");
}

// The contract by hand, in long double: all samples are kept, and mean and deviation are computed
// from all of them after each batch.
struct Expected {
  int samples = 0;
  bool close = false;  // the condition was once too close to equality for double
};

Expected expected_samples(const AdaptiveSettings& settings, const std::function<Rgb(int)>& value) {
  Expected expected;
  std::vector<long double> seen;
  while (static_cast<int>(seen.size()) < settings.max_samples) {
    const Rgb c = value(static_cast<int>(seen.size()));
    seen.push_back(0.2126L * c.r + 0.7152L * c.g + 0.0722L * c.b);
    if (seen.size() % settings.batch != 0) continue;
    const auto n = static_cast<long double>(seen.size());
    long double mean = 0, squares = 0;
    for (const long double v : seen) mean += v / n;
    for (const long double v : seen) squares += (v - mean) * (v - mean);
    const long double interval = 1.96L * std::sqrt(squares / (n - 1) / n);
    const long double allowed = settings.tolerance * mean;
    // If all are equal, rounding in long double is not a deviation.
    const bool constant = std::equal(seen.begin() + 1, seen.end(), seen.begin());
    if (!constant && std::abs(interval - allowed) < 1e-12L * allowed) expected.close = true;
    if (constant ? allowed > 0 : interval < allowed) break;
  }
  expected.samples = static_cast<int>(seen.size());
  return expected;
}

struct Sequence {
  std::string name;
  std::function<Rgb(int)> value;
};

// A number that depends on i alone, uniform in [0, 1).
double noise(std::uint64_t seed, int i) { return Sampler::for_pixel(seed, i, 0).next_1d(); }

std::vector<Sequence> sequences() {
  std::vector<Sequence> all{
      {"constant", [](int) { return gray(0.1); }},
      {"another constant",
       [](int) {
         return Rgb{1e-9, 3e5, 0.7};
       }},
      {"dark", [](int) { return Rgb{}; }},
      {"two values", [](int i) { return gray(i % 2 == 0 ? 0.1 : 0.3); }},
      {"a late jump", [](int i) { return gray(i < 70 ? 0.001 * (i % 3) : 5); }},
      {"light after long dark", [](int i) { return gray(i < 65 ? 0 : 1e-9); }},
      {"red alone is noisy",
       [](int i) {
         return Rgb{noise(1, i), 4, 4};
       }},
      {"green alone is noisy",
       [](int i) {
         return Rgb{4, 4 * noise(2, i), 4};
       }},
      {"nearly constant", [](int i) { return gray(1 + 1e-9 * noise(3, i)); }},
      {"fireflies", [](int i) { return gray(noise(4, i) < 0.01 ? 500 : 1); }},
  };
  for (const double rare : {0.01, 0.05, 0.3}) {
    for (std::uint64_t seed = 10; seed < 40; ++seed) {
      all.push_back({"a light hit with chance " + std::to_string(rare),
                     [=](int i) { return gray(noise(seed, i) < rare ? 1 : 0); }});
    }
  }
  for (std::uint64_t seed = 40; seed < 140; ++seed) {
    all.push_back({"uniform", [=](int i) { return gray(noise(seed, i)); }});
  }
  return all;
}

TEST_F(Pixel, takes_exactly_the_samples_that_the_interval_asks_for) {
  int stopped_early = 0, ran_out = 0, cut_short = 0;
  for (const Sequence& sequence : sequences()) {
    for (const AdaptiveSettings settings : {AdaptiveSettings{2048, 64, 0.05},
                                            {512, 16, 0.1},
                                            {100, 32, 0.05},
                                            {7, 7, 0.2},
                                            {300, 2, 0.3},
                                            {1000, 10, 0.01}}) {
      const Expected expected = expected_samples(settings, sequence.value);
      ASSERT_FALSE(expected.close) << sequence.name;
      play(sequence.value);
      const PixelEstimate pixel = adaptive_pixel(view_, 5, 6, settings, sampler_);
      EXPECT_EQ(pixel.samples, expected.samples) << sequence.name << ", batch " << settings.batch;
      EXPECT_EQ(script.at.size(), pixel.samples);
      long double sum = 0;
      for (int i = 0; i < expected.samples; ++i) sum += sequence.value(i).g;
      expect_exact(pixel.mean.g, static_cast<double>(sum / expected.samples), sequence.name,
                   expected.samples);
      stopped_early += pixel.samples < settings.max_samples ? 1 : 0;
      ran_out += pixel.samples == settings.max_samples ? 1 : 0;
      cut_short += pixel.samples % settings.batch != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(stopped_early, 300);
  EXPECT_GT(ran_out, 300);
  EXPECT_GT(cut_short, 30);
}

// s2 - s1^2 / n rounds below zero for half of all constants, and then its root is NaN.
TEST_F(Pixel, takes_one_batch_of_any_constant) {
  for (int i = 0; i < 2000; ++i) {
    const Rgb value = std::pow(10, 12 * noise(5, i) - 6) * Rgb{noise(6, i), noise(7, i), 1};
    play([value](int) { return value; });
    const PixelEstimate pixel = adaptive_pixel(view_, 5, 6, {1000, 32, 0.001}, sampler_);
    ASSERT_EQ(pixel.samples, 32) << value.r;
    expect_exact(pixel.mean, value, "constant");
  }
}

}  // namespace
}  // namespace proof
}  // namespace pt
