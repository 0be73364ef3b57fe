#include "grader/check/generators/points_in_pixel.h"
#include "grader/check/generators/random_numbers.h"
#include "grader/check/language/property.h"
#include "grader/tasks/estimate_pixel/inputs.h"
#include "grader/tasks/estimate_pixel/wild.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <fmt/format.h>

namespace grader::check {
namespace {

using namespace estimate_pixel_inputs;

// Numbers of samples that reveal a hidden maximum or a counter of one byte. All of them are tested.
constexpr std::array kMany{64, 100, 255, 256, 257, 1000, 1024, 4097};

// One more than a counter of two bytes can hold.
constexpr int kMost = 65537;

int some_samples() {
  return draw("samples", rc::gen::oneOf(whole(1, 20), rc::gen::element(1, 2, 3, 16, 17)));
}

void expect_a_call(const Estimate& e) { expect(!e.calls.empty(), "a call of radiance()", "none"); }

// Judges the average of the values that radiance() returned. The promise
// takes_the_samples_asked_for judges the number of calls, so the sum may be divided by this number
// or by `samples`.
void expect_average(int samples, const RadianceScript& script, const Estimate& e) {
  expect_a_call(e);
  const int calls = static_cast<int>(e.calls.size());
  pt::Rgb sum;
  for (int call = 0; call < calls; ++call) sum += script.at(call);
  const double precision = std::max(1e-5, 1e-7 * samples);
  for (int channel = 0; channel < 3; ++channel) {
    const double mean = sum[channel] / samples, of_calls = sum[channel] / calls;
    const double got = e.mean[channel];
    if (std::abs(got - of_calls) <= precision * of_calls) continue;
    expect_near(fmt::format("the mean of {} samples, in {}", samples, kChannels[channel]), got,
                mean, precision * mean);
  }
}

void expect_average(int samples) {
  const Pixel p = *pixel();
  const RadianceScript script = script_of(*any_radiances(), samples);
  const pt::Sampler sampler(draw("seed", sampler_seed()));
  expect_average(samples, script, estimate(p, samples, sampler, script));
}

PROMISE(estimate_pixel, averages_the_radiance) {
  for_all([] { expect_average(some_samples()); });
  for (const int samples : kMany) {
    for_all([=] { expect_average(samples); }, 1);
  }
  all_after_each(calls(), other_calls(other_counts()), [](const Call& c) {
    expect_average(c.samples, script_of(c.seen, c.samples), call(c));
  });
  expect_explained(wild_task());
}

void expect_calls(int samples, const Estimate& e) {
  expect_equal(fmt::format("calls of radiance() for {} samples", samples),
               static_cast<long long>(e.calls.size()), samples);
}

void expect_calls(int samples) {
  const Pixel p = *pixel();
  expect_calls(samples, estimate(p, samples, pt::Sampler(draw("seed", sampler_seed()))));
}

PROMISE(estimate_pixel, takes_the_samples_asked_for) {
  for_all([] { expect_calls(some_samples()); });
  for (const int samples : kMany) {
    for_all([=] { expect_calls(samples); }, 1);
  }
  for_all([] { expect_calls(kMost); }, 1);
  all_after_each(
      calls(), other_counts(), [](const Call& c) { expect_calls(c.samples, call(c)); }, 5);
  expect_explained(wild_task());
}

// The promise stays_inside_the_pixel judges which pixel the ray goes through. This one judges only
// where the ray is between the edges of a pixel.
PROMISE(estimate_pixel, sends_one_sample_through_the_centre) {
  for_all([] {
    const Pixel p = *pixel();
    const Estimate e = estimate(p, 1, pt::Sampler(draw("seed", sampler_seed())));
    expect_a_call(e);
    const pt::Vec2 at = in_pixel(p, e.calls[0].ray), off = slack(p);
    expect_near("from a pixel's left edge, in pixels", at.x - std::floor(at.x), 0.5, off.x);
    expect_near("from a pixel's bottom edge, in pixels", at.y - std::floor(at.y), 0.5, off.y);
  });
}

void expect_inside(const Pixel& p, const Estimate& e) {
  expect_a_call(e);
  const pt::Vec2 off = slack(p);
  for (const RadianceCall& call : e.calls) {
    expect_from_camera(call.ray, p.camera);
    const pt::Vec2 at = in_pixel(p, call.ray);
    expect(at.x >= -off.x && at.x <= 1 + off.x && at.y >= -off.y && at.y <= 1 + off.y,
           fmt::format(
               "a ray through pixel ({0}, {1}), which is the square from ({0}, {1}) to ({2}, {3})",
               p.x, p.y, p.x + 1, p.y + 1),
           fmt::format("one through the point ({:.5g}, {:.5g}) of the picture, counted in pixels",
                       p.x + at.x, p.y + at.y));
  }
}

void expect_inside(const Pixel& p, int samples, const pt::Sampler& sampler) {
  expect_inside(p, estimate(p, samples, sampler));
}

PROMISE(estimate_pixel, stays_inside_the_pixel) {
  for_all([] {
    const Pixel p = *pixel();
    expect_inside(p, some_samples(), pt::Sampler(draw("seed", sampler_seed())));
  });
  // The same pixel after another one.
  for_all(
      [] {
        const Pixel p = *pixel_of_a_long_picture();
        const pt::Sampler sampler(draw("seed", sampler_seed()));
        for (const auto& [x, y] : pixels_taken_for(p.x, p.y, p.width, p.height)) {
          Pixel other = p;
          other.x = x;
          other.y = y;
          estimate(other, 2, sampler);
          expect_inside(p, 2, sampler);
        }
      },
      20);
  // There are so many points that a pixel two thousandths too wide is seen.
  for_all([] { expect_inside(*whole_picture(), 4000, pt::Sampler(draw("seed", sampler_seed()))); },
          1);
  for_all([] {
    const Pixel p = *pixel();
    expect_inside(p, some_samples(), sampler_of_a_rare_number(6));
  });
  all_after_each(calls(), other_pixels<Call>(),
                 [](const Call& c) { expect_inside(c.pixel, call(c)); });
}

// The points of some calls. The promise stays_inside_the_pixel judges which pixel the rays go
// through; here it does not matter.
Points points_of_calls(const Pixel& p, int samples, int calls, std::uint64_t seed) {
  Points points;
  for (int i = 0; i < calls; ++i) {
    const Estimate e = estimate(p, samples, pt::Sampler::for_pixel(seed, i, 0));
    expect_a_call(e);
    for (const RadianceCall& call : e.calls) {
      const pt::Vec2 at = in_pixel(p, call.ray);
      points.push_back({at.x - std::floor(at.x), at.y - std::floor(at.y)});
    }
  }
  return points;
}

// The points of three calls are different, whatever the number of samples: all small numbers,
// squares and powers of two; a larger number and a larger square.
void expect_random_points(const Pixel& p, std::uint64_t seed) {
  std::vector<int> numbers(19);
  std::iota(numbers.begin(), numbers.end(), 2);
  numbers.insert(numbers.end(), {25, 32, 36, 49, 64, 100, 128, 256, *whole(257, 3000)});
  const int side = *whole(17, 50);
  numbers.push_back(side * side);
  for (const int samples : numbers) {
    const Points points = points_of_calls(p, samples, 3, seed);
    expect_different_coordinates(
        points, fmt::format("{} points, of three calls with {} samples", points.size(), samples));
  }
}

PROMISE(estimate_pixel, covers_the_whole_pixel) {
  // At least 2048 points: from one call, or from many calls of few samples.
  for (const int samples : {2048, 17, 9, 4, 2}) {
    for_all(
        [=] {
          const Pixel p = *large_pixel();
          const auto seed = draw("seed", sampler_seed());
          const int calls = 2047 / samples + 1;
          expect_even(points_of_calls(p, samples, calls, seed), calls);
        },
        1);
  }
  for_all(
      [] {
        const Pixel p = *large_pixel();
        expect_random_points(p, draw("seed", sampler_seed()));
      },
      1);
  // The first and the second point of each of many calls.
  for_all(
      [] {
        const Pixel p = *whole_picture();
        const auto seed = draw("seed", sampler_seed());
        Points firsts, seconds;
        std::vector<pt::Sampler::State> after_first, after;
        for (int i = 0; i < kIndependentPoints; ++i) {
          const Estimate e = estimate(p, 2, pt::Sampler::for_pixel(seed, i, 0));
          expect_a_call(e);
          firsts.push_back(points_of(p, e).front());
          after_first.push_back(e.calls.front().sampler);
          seconds.push_back(points_of(p, e).back());
          after.push_back(e.calls.back().sampler);
        }
        expect_independent_axes(seconds);
        expect_not_ahead(firsts, after_first);
        expect_not_ahead(seconds, after);
      },
      1);
  for_all(
      [] {
        const Pixel p = *whole_picture();
        const auto seed = draw("seed", sampler_seed());
        Points points;
        for (int i = 0; i < 2; ++i) {
          const Estimate e = estimate(p, 8000, pt::Sampler::for_pixel(seed, i, 0));
          for (const pt::Vec2 at : points_of(p, e)) points.push_back(at);
        }
        expect(!points.empty(), "a call of radiance()", "none");
        expect_points_at_the_edges(points);
        expect_no_frequent_point(points);
      },
      1);
}

PROMISE(estimate_pixel, passes_the_settings_on) {
  for_all([] {
    const Pixel p = *pixel();
    const pt::PathSettings settings = some_settings();
    const pt::Scene scene = some_scene();
    const int n = some_samples();
    const pt::Sampler sampler(draw("seed", sampler_seed()));
    const Estimate e = estimate(p, n, sampler, {}, settings, scene);
    expect_a_call(e);
    for (const RadianceCall& call : e.calls) expect_seen(call, settings, scene);
  });
  all_after_each(calls(), other_settings<Call>(), [](const Call& c) {
    const Estimate e = call(c);
    expect_a_call(e);
    const pt::Scene scene = scene_with(c.lights);
    for (const RadianceCall& each : e.calls) expect_seen(each, c.settings, scene);
  });
}

// Draws numbers until the sampler is in this state. Returns false if that takes too many numbers.
bool draw_up_to(const pt::Sampler::State& state, pt::Sampler& sampler) {
  constexpr int kMaxDraws = 2000;  // a right solution draws about ten per sample, or all at once
  for (int drawn = 0; drawn <= kMaxDraws; ++drawn) {
    if (sampler.state() == state) return true;
    sampler.next_1d();
  }
  return false;
}

PROMISE(estimate_pixel, draws_from_the_callers_sampler) {
  for_all([] {
    const Pixel p = *pixel();
    const int n = some_samples();
    const int numbers = draw("numbers that each call of radiance() draws", whole(1, 9));
    const pt::Sampler start(draw("seed", sampler_seed()));
    const Estimate e = estimate(p, n, start, {.numbers = numbers});
    expect_a_call(e);
    pt::Sampler at = start;  // follows the caller's sampler
    for (int i = 0; i < static_cast<int>(e.calls.size()); ++i) {
      expect(draw_up_to(e.calls[i].sampler, at),
             "each call of radiance() with the caller's sampler, as the draws before left it",
             fmt::format("in call {} another sampler, or one that went back", i + 1));
      for (int number = 0; number < numbers; ++number) at.next_1d();
    }
    expect(draw_up_to(e.sampler.state(), at),
           "a sampler that has advanced past all numbers that were drawn",
           "a sampler that has not advanced, so that the next pixel gets the same numbers");
  });
  expect_explained(wild_task());
}

PROMISE(estimate_pixel, forgets_the_pixel_before) {
  for_all([] {
    const Pixel first = *pixel(), second = *pixel();
    const int n = some_samples(), other = draw("samples of the second pixel", whole(1, 20));
    const pt::Sampler sampler(draw("seed", sampler_seed()));
    const RadianceScript by_direction{.of_call = [](int call, const pt::Ray& ray) {
      return pt::Rgb{ray.direction.x + 2, ray.direction.y + 2, call + 1.0};
    }};
    const Estimate before = estimate(first, n, sampler, by_direction);
    expect_a_call(before);
    // In another picture, the same pixel with the same sampler has another answer.
    if (draw("the second is the same pixel of another picture", rc::gen::arbitrary<bool>())) {
      estimate({*camera(), first.width, first.height, first.x, first.y}, n, sampler, by_direction);
    } else {
      estimate(second, other, pt::Sampler(1), by_direction);
    }
    const Estimate after = estimate(first, n, sampler, by_direction);
    expect_near("the mean, asked again after another pixel", after.mean, before.mean, 0);
    expect_equal("calls of radiance(), asked again after another pixel",
                 static_cast<long long>(after.calls.size()),
                 static_cast<long long>(before.calls.size()));
  });
}

}  // namespace
}  // namespace grader::check
