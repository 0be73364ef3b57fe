#include "grader/property/closed_forms.h"
#include "grader/tasks/adaptive_pixel/cases.h"

#include <array>

namespace grader {
namespace {

using namespace adaptive;

PROMISE(adaptive_pixel, stops_where_the_interval_is_narrow) {
  for_all(
      [] {
        const Case c = *rc::gen::oneOf(noise(), noise(), two_values(), jump());
        expect_right_count(c, ask(c));
      },
      60);
}

PROMISE(adaptive_pixel, checks_once_a_batch) {
  for_all(
      [] {
        const Case c = *anything();
        const int n = ask(c).estimate.samples;
        expect(n > 0 && (n % c.settings.batch == 0 || n == c.settings.max_samples),
               fmt::format("a multiple of {} samples, or {}", c.settings.batch,
                           c.settings.max_samples),
               fmt::format("{} samples", n));
      },
      60);
}

PROMISE(adaptive_pixel, takes_one_batch_of_a_constant) {
  for_all(
      [] {
        const Case c = *constant();
        expect_equal("samples of a constant", ask(c).estimate.samples, c.settings.batch);
      },
      60);
}

PROMISE(adaptive_pixel, never_exceeds_the_maximum) {
  for_all(
      [] {
        const Case c = *anything();
        const Answer answer = ask(c);
        expect(answer.estimate.samples <= c.settings.max_samples,
               fmt::format("at most {} samples", c.settings.max_samples),
               fmt::format("{}", answer.estimate.samples));
        expect_equal("calls of radiance(), and samples", static_cast<int>(answer.calls.size()),
                     answer.estimate.samples);
      },
      60);
}

PROMISE(adaptive_pixel, returns_the_mean_of_all_samples) {
  for_all(
      [] {
        const Case c = *anything();
        const Answer answer = ask(c);
        const int traced = static_cast<int>(answer.calls.size());
        Rgb mean;
        for (int i = 0; i < std::min(traced, c.settings.max_samples); ++i) {
          mean += c.seen[i] / traced;
        }
        expect_near(fmt::format("the mean of the {} samples", traced), answer.estimate.mean, mean,
                    1e-12 * max_channel(mean));
      },
      60);
}

PROMISE(adaptive_pixel, judges_by_luminance) {
  for_all(
      [] {
        const Case c = *rc::gen::exec([] {
          const Rgb value = any_radiance(), other = any_radiance();
          AdaptiveSettings settings = any_settings();
          settings.max_samples = 10 * settings.batch;
          settings.tolerance = *magnitude(0.03, 0.3);
          return pixel(fmt::format("any mixture of {} and {}", show(value), show(other)), settings,
                       [=](int, double xi) { return (1 - xi) * value + xi * other; });
        });
        expect_right_count(c, ask(c));
      },
      60);
}

PROMISE(adaptive_pixel, goes_on_while_it_is_dark) {
  for_all(
      [] {
        const Case c = *rarely_lit();
        expect_right_count(c, ask(c));
      },
      60);
}

PROMISE(adaptive_pixel, uses_the_batch_and_the_tolerance_given) {
  for_all(
      [] {
        const Case c = *rc::gen::exec([] {
          Case made = *noise();
          made.settings.batch = *whole(2, 20);
          made.settings.tolerance *= *real(0.5, 2);
          return made;
        });
        expect_right_count(c, ask(c));
      },
      60);
}

PROMISE(adaptive_pixel, covers_the_whole_pixel) {
  constexpr int kSide = 4;
  for_all(
      [] {
        const Case c = *rc::gen::exec([] {
          return pixel("0 and 1 in turn", {1600, 1600, 1e-3},
                       [](int i, double) { return pt::gray(i % 2); });
        });
        std::array<int, kSide * kSide> found{};
        const Answer answer = ask(c);
        for (const RadianceCall& call : answer.calls) {
          const pt::Vec2 at = on_picture(c.camera, call.ray.direction);
          const double i = at.x * c.width - c.x, j = at.y * c.height - c.y;
          expect(i > -1e-9 && i < 1 + 1e-9 && j > -1e-9 && j < 1 + 1e-9, "rays through the pixel",
                 fmt::format("one through ({}, {}) of it", i, j));
          const auto cell = [](double a) {
            return std::clamp(static_cast<int>(kSide * a), 0, kSide - 1);
          };
          ++found[kSide * cell(j) + cell(i)];
        }
        double chi_square = 0;
        const double expected = static_cast<double>(answer.calls.size()) / found.size();
        for (const int count : found) chi_square += std::pow(count - expected, 2) / expected;
        const double limit = chi_square_limit(static_cast<int>(found.size()));
        expect(chi_square < limit,
               fmt::format("rays all over the pixel: chi-square of {} in {} cells below {:.4g}",
                           answer.calls.size(), found.size(), limit),
               fmt::format("{:.4g}", chi_square));
      },
      4);
}

PROMISE(adaptive_pixel, forgets_the_pixel_before) {
  for_all(
      [] {
        const Case before = *anything(), c = *noise();
        const Answer first = ask(c);
        ask(before);
        const Answer again = ask(c);
        expect_right_count(c, again);
        expect_near("the mean, asked for a second time", again.estimate.mean, first.estimate.mean,
                    0);
        expect_equal("the samples, asked for a second time", again.estimate.samples,
                     first.estimate.samples);
      },
      30);
}

}  // namespace
}  // namespace grader
