#include "grader/property/property.h"
#include "grader/tasks/estimate_pixel/cases.h"

#include <algorithm>
#include <cmath>

namespace grader {
namespace {

using namespace estimate_pixel_cases;

// Rounding in a camera ray and back, in pixels of pictures up to 500 wide.
constexpr double kPixelError = 1e-9;

int some_samples() { return draw("samples", whole(1, 20)); }

PROMISE(estimate_pixel, averages_the_radiance) {
  for_all([] {
    const Pixel p = *pixel();
    std::vector<pt::Rgb> script;
    for (int i = some_samples(); i > 0; --i) script.push_back(draw("radiance", color(0, 10)));
    const int n = static_cast<int>(script.size());
    const auto seed = draw("seed", sampler_seed());
    const Estimate e = estimate(p, n, pt::Sampler(seed), [&](int call, const pt::Ray&) {
      return call < n ? script[call] : pt::Rgb{};
    });
    pt::Rgb mean;
    for (const pt::Rgb& radiance : script) mean += radiance / n;
    expect_near("the mean", e.mean, mean, 1e-12);
  });
}

PROMISE(estimate_pixel, takes_the_samples_asked_for) {
  for_all([] {
    const Pixel p = *pixel();
    const int n = some_samples();
    const Estimate e = estimate(p, n, pt::Sampler(draw("seed", sampler_seed())));
    expect_equal("calls of radiance()", static_cast<long long>(e.calls.size()), n);
  });
}

PROMISE(estimate_pixel, sends_one_sample_through_the_centre) {
  for_all([] {
    const Pixel p = *pixel();
    const Estimate e = estimate(p, 1, pt::Sampler(draw("seed", sampler_seed())));
    expect_equal("calls of radiance()", static_cast<long long>(e.calls.size()), 1);
    const pt::Vec2 at = in_pixel(p, e.calls[0].ray);
    expect_near("from the pixel's left edge, in pixels", at.x, 0.5, kPixelError);
    expect_near("from the pixel's bottom edge, in pixels", at.y, 0.5, kPixelError);
  });
}

PROMISE(estimate_pixel, stays_inside_the_pixel) {
  for_all([] {
    const Pixel p = *pixel();
    const int n = some_samples();
    const Estimate e = estimate(p, n, pt::Sampler(draw("seed", sampler_seed())));
    expect(!e.calls.empty(), "a call of radiance()", "none");
    for (const RadianceCall& call : e.calls) {
      const pt::Vec2 at = in_pixel(p, call.ray);
      expect_near("from the pixel's middle to the right, in pixels", at.x - 0.5, 0,
                  0.5 + kPixelError);
      expect_near("from the pixel's middle upwards, in pixels", at.y - 0.5, 0, 0.5 + kPixelError);
    }
  });
}

// The value that a chi-square variable exceeds with a chance of 1e-7 (Wilson and Hilferty 1931).
double chi_square_limit(int degrees) {
  const double spread = 2.0 / (9 * degrees);
  return degrees * std::pow(1 - spread + 5.2 * std::sqrt(spread), 3);
}

// Counts the points in 8 x 8 cells of the pixel.
void expect_even(const std::vector<pt::Vec2>& points) {
  constexpr int kCells = 8;
  std::vector<int> counts(kCells * kCells);
  for (const pt::Vec2 at : points) {
    expect(at.x > -kPixelError && at.x < 1 + kPixelError && at.y > -kPixelError &&
               at.y < 1 + kPixelError,
           "a point of the pixel", grader::show(at));
    const int column = std::clamp(static_cast<int>(at.x * kCells), 0, kCells - 1);
    const int row = std::clamp(static_cast<int>(at.y * kCells), 0, kCells - 1);
    ++counts[row * kCells + column];
  }
  const double even = static_cast<double>(points.size()) / (kCells * kCells);
  expect(even > 20, "more than 20 points a cell", grader::show(even));
  double chi_square = 0;
  for (const int count : counts) chi_square += (count - even) * (count - even) / even;
  const double limit = chi_square_limit(kCells * kCells - 1);
  expect(chi_square <= limit, "chi-square over 8 x 8 cells of at most " + grader::show(limit),
         grader::show(chi_square) + " with counts from " +
             std::to_string(*std::ranges::min_element(counts)) + " to " +
             std::to_string(*std::ranges::max_element(counts)));
}

PROMISE(estimate_pixel, covers_the_whole_pixel) {
  // Many samples of one pixel, few of many, and two of still more.
  for (const auto& [pixels, samples] :
       {std::pair{1, 2048}, std::pair{128, 16}, std::pair{1000, 2}}) {
    for_all(
        [pixels = pixels, samples = samples] {
          const Pixel p = *pixel();
          const auto seed = draw("seed", sampler_seed());
          std::vector<pt::Vec2> points;
          for (int i = 0; i < pixels; ++i) {
            const auto calls = estimate(p, samples, pt::Sampler::for_pixel(seed, i, 0)).calls;
            for (const RadianceCall& call : calls) points.push_back(in_pixel(p, call.ray));
          }
          expect_even(points);
        },
        2);
  }
}

bool equal(const pt::PathSettings& a, const pt::PathSettings& b) {
  return a.light_samples == b.light_samples && a.direct == b.direct && a.survival == b.survival &&
         a.from == b.from && a.to == b.to && a.show_normals == b.show_normals;
}

// How many numbers were drawn from `start` to get to `state`; -1 if it takes more than `most`.
int numbers_drawn(pt::Sampler start, const pt::Sampler::State& state, int most) {
  for (int drawn = 0; drawn <= most; ++drawn) {
    if (start.state() == state) return drawn;
    start.next_1d();
  }
  return -1;
}

PROMISE(estimate_pixel, passes_the_settings_on) {
  for_all([] {
    const Pixel p = *pixel();
    const pt::PathSettings settings = some_settings();
    const int n = some_samples();
    const pt::Sampler start(draw("seed", sampler_seed()));
    const Estimate e = estimate(p, n, start, {}, settings);
    expect(!e.calls.empty(), "a call of radiance()", "none");
    int before = 0;
    for (const RadianceCall& call : e.calls) {
      expect(equal(call.settings, settings), "the view's settings", "other settings");
      const int drawn = numbers_drawn(start, call.sampler, 64 * (n + 1));
      expect(drawn >= before, "the sampler that estimate_pixel was given, as far as it was used",
             "another sampler, or one that went back");
      before = drawn;
    }
    expect(numbers_drawn(start, e.sampler.state(), 64 * (n + 1)) >= before,
           "the caller's sampler to have gone on", "one that stayed behind");
  });
}

PROMISE(estimate_pixel, forgets_the_pixel_before) {
  for_all([] {
    const Pixel first = *pixel(), second = *pixel();
    const int n = some_samples(), other = draw("samples of the second pixel", whole(1, 20));
    const pt::Sampler sampler(draw("seed", sampler_seed()));
    const Script by_direction = [](int call, const pt::Ray& ray) {
      return pt::Rgb{ray.direction.x + 2, ray.direction.y + 2, call + 1.0};
    };
    const Estimate before = estimate(first, n, sampler, by_direction);
    estimate(second, other, pt::Sampler(1), by_direction);
    const Estimate after = estimate(first, n, sampler, by_direction);
    expect_near("the mean, asked again after another pixel", after.mean, before.mean, 0);
    expect_equal("calls of radiance()", static_cast<long long>(after.calls.size()),
                 static_cast<long long>(before.calls.size()));
  });
}

}  // namespace
}  // namespace grader
