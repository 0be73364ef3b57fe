#include "pt/render/rounds.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace pt {

namespace {

using Clock = std::chrono::steady_clock;

// Not inline: g++ 12 drops both conversions where it makes a vector of two of them.
[[gnu::noinline]] double as_float(double value) { return static_cast<float>(value); }

// Mean and variance of one number, of both groups of samples (Chan, Golub and LeVeque 1979).
struct Moments {
  double mean, variance;
};
Moments joined(Moments a, int n_a, Moments b, int n_b) {
  const double n = static_cast<double>(n_a) + n_b, step = b.mean - a.mean;
  const double squares =
      a.variance * (n_a - 1) + b.variance * (n_b - 1) + step * step * n_a * n_b / n;
  return {a.mean + step * n_b / n, squares / (n - 1)};
}

// The pixel with more samples, from the numbers that a file keeps of the first ones.
FilmPixel joined(const FilmPixel& before, const FilmPixel& more) {
  FilmPixel both;
  const auto join = [&](double mean_a, double variance_a, double mean_b, double variance_b) {
    return joined({as_float(mean_a), as_float(variance_a)}, before.samples, {mean_b, variance_b},
                  more.samples);
  };
  for (const auto channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
    const Moments m = join(before.mean.*channel, before.variance.*channel, more.mean.*channel,
                           more.variance.*channel);
    both.mean.*channel = m.mean;
    both.variance.*channel = m.variance;
  }
  const Rgb mean{as_float(before.mean.r), as_float(before.mean.g), as_float(before.mean.b)};
  both.variance_y =
      join(luminance(mean), before.variance_y, luminance(more.mean), more.variance_y).variance;
  both.samples = before.samples + more.samples;
  return both;
}

// The samples that every pixel has after the next round. None is left alone for the last round:
// a single sample goes through the centre of its pixel.
int next_target(int least, int wanted) {
  const int next = (least / kRound + 1) * kRound;
  return wanted - next <= 1 ? wanted : next;
}

RenderedPixel go_on(const View& view, int x, int y, RenderSettings settings, int target,
                    const FilmPixel& before) {
  const bool is_done = settings.adaptive ? before.samples > 0 : before.samples >= target;
  if (is_done) return {before, 0};
  if (before.samples == 0) {
    settings.samples = target;
    return render_pixel(view, x, y, settings);
  }
  settings.samples = std::max(2, target - before.samples);
  settings.seed += 0x9e3779b97f4a7c15 * static_cast<std::uint64_t>(before.samples);
  RenderedPixel rendered = render_pixel(view, x, y, settings);
  rendered.pixel = joined(before, rendered.pixel);
  return rendered;
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

SampleRange samples_of(const Film& film) {
  const auto [least, most] = std::minmax_element(
      film.pixels.begin(), film.pixels.end(),
      [](const FilmPixel& a, const FilmPixel& b) { return a.samples < b.samples; });
  return {least->samples, most->samples};
}

RenderResult render_rounds(const View& view, const RenderSettings& settings, Film start,
                           std::optional<double> seconds,
                           const std::function<void(double)>& progress,
                           const std::atomic<bool>* stop) {
  RenderResult all;
  all.film = start.pixels.empty() ? Film(view.width, view.height) : std::move(start);
  const Clock::time_point begin = Clock::now();
  const int wanted = settings.adaptive ? 1 : settings.samples;
  const int first = std::min(samples_of(all.film).least, wanted);
  double last_round = 0;
  for (int least = first; least < wanted; least = samples_of(all.film).least) {
    if (seconds && least > first && seconds_since(begin) + last_round > *seconds) return all;
    const int target = next_target(least, wanted);
    const auto round_progress = [&](double part) {
      const double done = least - first + part * (target - least);
      const double of_time = seconds ? seconds_since(begin) / *seconds : 0;
      progress(std::min(1.0, std::max(of_time, done / (wanted - first))));
    };
    const auto pixel = [&](int x, int y, const FilmPixel& before) {
      return go_on(view, x, y, settings, target, before);
    };
    RenderResult round = render_pixels(
        view, std::move(all.film), settings.threads, pixel,
        progress ? std::function<void(double)>(round_progress) : std::function<void(double)>{},
        stop);
    all.film = std::move(round.film);
    last_round = round.seconds;
    add(all, round);
    if (!round.complete) return all;
  }
  all.complete = true;
  return all;
}

}  // namespace pt
