#include "grader/check/generators/cameras.h"
#include "grader/check/generators/points_in_pixel.h"
#include "grader/check/generators/random_numbers.h"
#include "grader/tasks/adaptive_pixel/counts.h"
#include "grader/tasks/adaptive_pixel/inputs.h"
#include "grader/tasks/adaptive_pixel/known.h"
#include "grader/tasks/adaptive_pixel/wild.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace grader::check {
namespace {

using namespace adaptive_pixel_inputs;

constexpr int kCases = 60;
constexpr int kLongCases = 4;  // each has thousands of samples

void expect_known_count(const Known& known) {
  if (is_single_precision_allowed()) return expect_right_count(known.pixel, ask(known.pixel));
  expect_count("", known.pixel, samples_of(ask(known.pixel)), known.samples);
}

PROMISE(adaptive_pixel, stops_where_the_interval_is_narrow) {
  for_all(
      [] {
        const Case c = *rc::gen::oneOf(noise(), noise(), two_values(), jump(), late_jump());
        expect_right_count(c, ask(c));
      },
      2 * kCases);
  for_all(
      [] {
        const Case c = *anything_long();
        expect_right_count(c, ask(c));
      },
      kLongCases);
  // Counters of a byte and of ten bits are too small for the last two, and of eleven bits below.
  for (const int from : {20, 60, 130, 260, 1030}) {
    for_all([=] { expect_known_count(*narrow_after(*whole(from, from + 70), 1e-4, 1)); }, 2);
  }
  for_all([] { expect_known_count(*narrow_after(*whole(2100, 2400), 1e-4, 1)); }, 1);
  for (const int batch : {2, 4, 8}) {
    for (const bool divides_by_n : {true, false}) {
      for (const Side side : {Side::narrow, Side::wide}) {
        for_all(
            [=] {
              const Case c = *at_the_threshold(batch, divides_by_n, side);
              expect_right_count(c, ask(c));
            },
            1);
      }
    }
  }
  all_after_each(
      calls(), other_ends(), [](const Call& c) { expect_right_count(c.pixel, call(c)); }, 5);
  expect_explained(wild_task());
}

PROMISE(adaptive_pixel, checks_once_a_batch) {
  for_all(
      [] {
        const Case c = *anything();
        const int n = samples_of(ask(c));
        expect(n > 0 && (n % c.settings.batch == 0 || n == c.settings.max_samples),
               fmt::format("a multiple of {} samples, or {}", c.settings.batch,
                           c.settings.max_samples),
               fmt::format("{} samples", n));
      },
      kCases);
  expect_explained(wild_task());
}

PROMISE(adaptive_pixel, takes_one_batch_of_a_constant) {
  const auto property = [](Settings settings) {
    const Case c = *constant(settings);
    expect_count(" of a constant", c, samples_of(ask(c)), c.settings.batch);
  };
  for_all([&] { property(any_settings); }, kCases);
  for_all([&] { property(tight); }, kCases);
  for_all([&] { property(many_samples); }, kLongCases);
  for_all([&] { property(ten_thousand); }, 1);
  for_all([&] { property(more_than_two_bytes_count); }, 1);
  for_all([&] { property(more_than_anybody_takes); }, 4);
}

PROMISE(adaptive_pixel, never_exceeds_the_maximum) {
  for_all(
      [] {
        const Case c = *anything();
        const Answer answer = ask(c);
        const int n = answer.estimate.samples;
        expect(n >= 1 && n <= c.settings.max_samples,
               fmt::format("samples = 1 to {}", c.settings.max_samples),
               fmt::format("samples = {}, after {} calls of radiance()", n, answer.calls.size()));
        expect_equal("calls of radiance(), and samples", static_cast<int>(answer.calls.size()), n);
      },
      kCases);
  expect_explained(wild_task());
}

PROMISE(adaptive_pixel, returns_the_mean_of_all_samples) {
  const auto expect_mean = [](const Case& c, const Answer& answer) {
    const int traced = static_cast<int>(answer.calls.size());
    expect(traced > 0, "a call of radiance()", "none");
    const double summing = is_single_precision_allowed() ? 0x1p-24 : 0;  // error per sample
    Rgb mean;
    for (int i = 0; i < std::min(traced, c.settings.max_samples); ++i) mean += c.seen[i] / traced;
    expect_near(fmt::format("the mean of the {} samples", traced), answer.estimate.mean, mean,
                (kColorPrecision + summing * traced) * max_channel(mean));
  };
  const auto property = [&](const Case& c) { expect_mean(c, ask(c)); };
  for_all([&] { property(*anything()); }, kCases);
  for_all([&] { property(*anything_long()); }, kLongCases);
  // Ten thousand samples show the rounding errors of a sum in float.
  for_all([&] { property(*constant(ten_thousand)); }, 1);
  all_after_each(calls(), other_calls(other_ends()),
                 [&](const Call& c) { expect_mean(c.pixel, call(c)); });
  expect_explained(wild_task());
}

PROMISE(adaptive_pixel, judges_by_luminance) {
  for (const Channels channels : {Channels::all_different, Channels::red_is_green,
                                  Channels::red_is_blue, Channels::green_is_blue}) {
    for_all(
        [=] {
          const Case c = *one_brightness(channels);
          expect_count(" of one brightness in many hues", c, samples_of(ask(c)), c.settings.batch);
        },
        kCases / 6);
  }
  for_all(
      [] {
        const Case c = *red_and_green();
        expect_count(" of two brightnesses", c, samples_of(ask(c)), c.settings.max_samples);
      },
      kCases / 2);
}

PROMISE(adaptive_pixel, does_not_stop_just_because_it_is_dark) {
  for_all(
      [] {
        const Case c = *rarely_lit();
        expect_count(", only few of them lit", c, samples_of(ask(c)), c.settings.max_samples);
      },
      kCases);
}

PROMISE(adaptive_pixel, uses_the_batch_and_the_tolerance_given) {
  for_all([] { expect_known_count(*far_from_the_threshold()); }, kCases);
  for_all([] { expect_known_count(*narrow_after(*whole(2, 10), 1e-4, 2 * least_tolerance())); },
          10);
  for_all([] { expect_known_count(*narrow_after(1, 0.8, 1)); }, 5);
}

// Returns how many numbers were drawn between `start` and `state`, or -1 if more than `most`.
int numbers_drawn(pt::Sampler start, const pt::Sampler::State& state, int most) {
  for (int drawn = 0; drawn <= most; ++drawn) {
    if (start.state() == state) return drawn;
    start.next_1d();
  }
  return -1;
}

PROMISE(adaptive_pixel, passes_the_settings_on) {
  for_all(
      [] {
        const Case c = *anything();
        const pt::PathSettings settings = some_settings();
        const pt::Scene scene = some_scene();
        const Answer answer = ask(c, settings, pt::Sampler(c.seed), scene);
        const int most = 64 * (c.settings.max_samples + 1);
        expect(!answer.calls.empty(), "a call of radiance()", "none");
        int before = 0;
        for (const RadianceCall& call : answer.calls) {
          expect_seen(call, settings, scene);
          const int drawn = numbers_drawn(pt::Sampler(c.seed), call.sampler, most);
          expect(drawn >= before, "the sampler that adaptive_pixel was given, in its present state",
                 "another sampler, or one that went back");
          before = drawn;
        }
        const int drawn = numbers_drawn(pt::Sampler(c.seed), answer.sampler.state(), most);
        expect(drawn != 0 || before > 0,
               "numbers drawn from the sampler, for a random place of each sample in the pixel",
               "none: all samples have the same place, or numbers from elsewhere choose it");
        expect(drawn >= before, "a sampler that has advanced",
               drawn == 0 ? "one that has not advanced: a copy of it was used"
                          : "one that went back, or another one");
      },
      20);
  all_after_each(calls(), other_settings<Call>(), [](const Call& c) {
    const Answer answer = call(c);
    expect(!answer.calls.empty(), "a call of radiance()", "none");
    const pt::Scene scene = scene_with(c.lights);
    for (const RadianceCall& each : answer.calls) expect_seen(each, c.settings, scene);
  });
  expect_explained(wild_task());
}

// A pixel of a picture of some size. The first and the last columns and rows are more frequent.
rc::Gen<Case> in_picture(const rc::Gen<Case>& cases, const rc::Gen<std::pair<int, int>>& sizes) {
  return rc::gen::exec([=] {
    Case c = *cases;
    std::tie(c.width, c.height) = *sizes;
    c.x = *rc::gen::oneOf(rc::gen::element(0, c.width - 1), whole(0, c.width - 1));
    c.y = *rc::gen::oneOf(rc::gen::element(0, c.height - 1), whole(0, c.height - 1));
    return c;
  });
}

// Returns the points of the pixel that the rays go through. Fails if one is outside of the pixel.
Points points_inside(const Case& c, const Answer& answer) {
  expect(!answer.calls.empty(), "a call of radiance()", "none");
  const pt::Vec2 slack = ray_slack(c.camera, c.width, c.height);
  Points points;
  for (const RadianceCall& call : answer.calls) {
    expect_from_camera(call.ray, c.camera);
    const pt::Vec2 at = in_pixel(c, call.ray);
    expect(at.x > -slack.x && at.x < 1 + slack.x && at.y > -slack.y && at.y < 1 + slack.y,
           "rays through the pixel, from (0, 0) to (1, 1)",
           fmt::format("one through ({:.4g}, {:.4g})", at.x, at.y));
    points.push_back(at);
  }
  return points;
}

Points points_inside(const Case& c) { return points_inside(c, ask(c)); }

// A last batch that is cut short reveals points that are even only in whole batches; small batches
// reveal a batch whose first point differs from the rest.
PROMISE(adaptive_pixel, covers_the_whole_pixel) {
  for (const auto& [batch, most] :
       {std::pair{2, 1600}, std::pair{5, 1600}, std::pair{9000, 9000}, std::pair{1800, 2400}}) {
    for_all(
        [batch = batch, most = most] {
          const rc::Gen<Case> cases = rc::gen::exec([=] {
            return pixel("0 and 1 in turn", {most, batch, 1e-3},
                         [](int i, double) { return pt::gray(i % 2); });
          });
          expect_even(points_inside(*in_picture(cases, rc::gen::just(std::pair{8, 5}))));
        },
        1);
  }
  // One sample of each of many calls: the first one, and every time another one. Strata may be filled in
  // turn, so that the first ones are close together.
  for (const bool first : {true, false}) {
    for_all(
        [=] {
          const int samples = first ? 16 : 64;
          Case c = *rc::gen::exec([=] {
            return pixel("always 1", {samples, samples, 1e-3}, always(pt::gray(1)));
          });
          c.x = c.y = 0;
          c.width = c.height = 1;
          Points points;
          std::vector<pt::Sampler::State> after;
          for (int i = 0; i < kIndependentPoints; ++i, ++c.seed) {
            const Answer answer = ask(c);
            const int of = first ? 0 : i % samples;
            points.push_back(points_inside(c, answer).at(of));
            after.push_back(answer.calls.at(of).sampler);
          }
          expect_not_ahead(points, after);
          if (first) expect_different_coordinates(points, "the first points of many calls");
          if (!first) expect_independent_axes(points);
        },
        1);
  }
  for_all(
      [] {
        const Case c = *constant();
        points_inside(c, ask(c, {}, sampler_of_a_rare_number(6)));
      },
      40);
  for_all(
      [] {
        points_inside(*in_picture(
            constant(), rc::gen::element(std::pair{64, 32}, std::pair{3, 100}, std::pair{7, 500},
                                         std::pair{1920, 1080}, std::pair{4000, 3000})));
        points_inside(*in_picture(constant(), many_pixels()));
      },
      20);
  // The same pixel after another one.
  for_all(
      [] {
        const Case c =
            *in_picture(constant(), rc::gen::element(std::pair{48, 16}, std::pair{16, 48}));
        for (const auto& [x, y] : pixels_taken_for(c.x, c.y, c.width, c.height)) {
          Case other = c;
          other.x = x;
          other.y = y;
          points_inside(other);
          points_inside(c);
        }
      },
      20);
  all_after_each(calls(), other_pixels<Call>(),
                 [](const Call& c) { points_inside(c.pixel, call(c)); });
}

// Estimates a pixel twice, with another pixel in between. Where the right count is known, sums that
// are never reset already show in the first estimate.
PROMISE(adaptive_pixel, forgets_the_pixel_before) {
  for_all(
      [] {
        const Case before = *anything();
        const auto [c, samples] = *maybe_known();
        const Answer first = ask(c);
        Case same_place = before;  // the same pixel of another picture, with the same sampler
        std::tie(same_place.x, same_place.y, same_place.seed) = std::tie(c.x, c.y, c.seed);
        ask(*rc::gen::arbitrary<bool>() ? before : same_place);
        const Answer again = ask(c);
        if (samples > 0) expect_count("", c, samples_of(first), samples);
        expect_equal("the samples, asked for a second time", samples_of(again), samples_of(first));
        expect_equal("calls of radiance(), asked for a second time",
                     static_cast<int>(again.calls.size()), static_cast<int>(first.calls.size()));
        expect_near("the mean, asked for a second time", again.estimate.mean, first.estimate.mean,
                    0);
      },
      kCases);
}

}  // namespace
}  // namespace grader::check
