#include "measure/scene/study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace measure::scene {

namespace {

constexpr int kTurns = 3;

// Shares of the time.
constexpr double kOfBounces = 0.25, kOfOneRender = 0.025;

// Per pixel of one short render. With fewer than 64 the golden would be noise, and so would every error beside it.
constexpr int kFewestTried = 64, kMaxTried = 1 << 14;
constexpr double kClock = 0.01;  // relative: no time is more certain

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// The weighted mean over the pixels of two independent halves. Its standard error comes from the
// differences between the halves: differences between pixels are not errors.
Uncertain mean_of_halves(const std::vector<double>& a, const std::vector<double>& b,
                         const pt::Goldens& goldens) {
  const auto n = static_cast<double>(a.size());
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double half = goldens.weight(i) * (a[i] - b[i]) / 2;
    sum += goldens.weight(i) * (a[i] + b[i]) / 2;
    squares += half * half;
  }
  return {sum / n, std::sqrt(squares) / n};
}

Uncertain seconds_of(const RenderedPixels& a, const RenderedPixels& b) {
  const double first = a.cpu_seconds / static_cast<double>(a.all_samples());
  const double second = b.cpu_seconds / static_cast<double>(b.all_samples());
  const double mean = (first + second) / 2;
  return {mean, std::max(std::abs(first - second) / 2, kClock * mean)};
}

std::vector<pt::BounceRange> one_by_one() {
  std::vector<pt::BounceRange> ranges;
  for (int k = 0; k <= kToldApart; ++k) ranges.push_back({k, k});
  ranges.push_back({kToldApart + 1, kAllBounces});
  return ranges;
}

// The light that each pixel misses with at most m bounces: first all of it, then for m = 0, 1, ...
std::vector<std::vector<double>> missing(const MeasuredApart& apart) {
  std::vector<std::vector<double>> rest(apart.mean.size());
  std::vector<double> sum(apart.mean[0].size());
  for (std::size_t k = apart.mean.size(); k-- > 0;) {
    rest[k] = sum;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += apart.mean[k][i];
  }
  rest.insert(rest.begin(), sum);  // the whole picture
  return rest;
}

}  // namespace

std::optional<double> seen_bias(const Uncertain& bias2) {
  if (!(bias2.value > kSignificant * bias2.error)) return {};
  return std::sqrt(bias2.value);
}

pt::PathSettings path_of(const Way& way, int light_samples) {
  pt::PathSettings path;
  path.light_samples = light_samples;
  path.direct = way.direct;
  path.survival = way.survival;
  path.from = 0;
  path.to = way.bounces;
  return path;
}

Study::Study(const pt::View& view, int threads, std::uint64_t seed, const StudyLimits& limits,
             std::function<void(double)> progress, int bounces,
             const std::function<void(double)>& announce, const Reference& reference)
    : view_(view),
      threads_(threads),
      seed_(seed),
      limits_(limits),
      progress_(std::move(progress)),
      pixels_(spread_pixels(view.width, view.height, limits.pixels, seed)),
      has_reference_(reference != nullptr) {
  look_at_bounces(bounces, announce, reference);
}

void Study::look_at_bounces(int bounces, const std::function<void(double)>& announce,
                            const Reference& reference) {
  const pt::View view = view_of({pt::PathSettings::Direct::lights, kAllBounces}, 1);
  const std::vector<pt::BounceRange> ranges = one_by_one();
  const int samples =
      samples_in(kOfBounces * limits_.seconds,
                 [&](const pt::RenderSettings& settings, std::span<const PixelAt> some) {
                   return made_apart(view, settings, ranges, some).cpu_seconds;
                 });
  // A few samples tell how long the fewest take, if there is time for no more.
  const auto of_all = static_cast<double>(pixels_.size());
  const std::vector<PixelAt> some = every(8);
  double plain = 0;
  if (limits_.samples == 0) {
    // Of fewer samples the calls of a box would take most of the time.
    constexpr int kLook = 16;
    const double before = seconds_;
    made(view, {kLook, {}, seed_, threads_}, some);
    plain = (seconds_ - before) / (kLook * static_cast<double>(some.size()));
  }
  const double renders = (1 - kOfBounces) / kOfOneRender;
  expected_ = kOfBounces * limits_.seconds +
              renders * std::max(kOfOneRender * limits_.seconds, kFewestTried * plain * of_all);
  if (announce) announce(expected_);
  std::vector<std::vector<double>> rest[2];
  std::vector<double> golden[2];
  for (int half = 0; half < 2; ++half) {
    rest[half] = missing(made_apart(view, next_render(samples / 2), ranges, pixels_));
    golden[half] = rest[half][0];
    if (reference) {
      const Way way{pt::PathSettings::Direct::lights, bounces};
      golden[half] = reference(path_of(way, 1), samples / 2, next_render(1).seed);
    }
    if (reference || bounces > kToldApart) continue;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      golden[half][i] -= rest[half][bounces + 1][i];
    }
  }
  goldens_ = {golden[0], golden[1]};
  // The noise of two independent means does not bias their product.
  for (int m = 0; m <= kToldApart; ++m) {
    std::vector<double> squares;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      squares.push_back(goldens_.weight(i) * rest[0][m + 1][i] * rest[1][m + 1][i]);
    }
    bias2_.push_back(mean_of(squares));
    bias2_.back().value = std::max(0.0, bias2_.back().value);
  }
}

RenderedPixels Study::made(const pt::View& view, const pt::RenderSettings& settings,
                           std::span<const PixelAt> pixels) {
  const Stopwatch watch;
  RenderedPixels result = measure(view, settings, pixels);
  advance(result.cpu_seconds, watch.seconds());
  return result;
}

MeasuredApart Study::made_apart(const pt::View& view, const pt::RenderSettings& settings,
                                std::span<const pt::BounceRange> ranges,
                                std::span<const PixelAt> pixels) {
  const Stopwatch watch;
  MeasuredApart result = measure_apart(view, settings, ranges, pixels);
  advance(result.cpu_seconds, watch.seconds());
  return result;
}

void Study::advance(double cpu_seconds, double seconds) {
  cpu_seconds_ += cpu_seconds;
  seconds_ += seconds;
  if (progress_ && expected_ > 0) progress_(std::min(0.99, seconds_ / expected_));
}

// On a busy machine that is less than all threads could use.
double Study::cpu_seconds_in(double seconds) const {
  const double idle = threads_;
  return seconds * (seconds_ > 0 ? std::min(idle, cpu_seconds_ / seconds_) : idle);
}

bool Study::is_black() const { return !(goldens_.dark() > 0); }

std::vector<Tried> Study::try_out(const Way& way, const std::vector<int>& light_samples) {
  std::vector<int> samples;
  samples.reserve(light_samples.size());
  for (const int l : light_samples) {
    samples.push_back(samples_in(kOfOneRender * limits_.seconds, view_of(way, l)));
  }
  std::vector<RenderedPixels> halves[2];
  for (std::vector<RenderedPixels>& half : halves) {
    for (std::size_t k = 0; k < samples.size(); ++k) {
      half.push_back(made(view_of(way, light_samples[k]), next_render(samples[k] / 2), pixels_));
    }
  }
  std::vector<Tried> tried;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const RenderedPixels &a = halves[0][k], &b = halves[1][k];
    tried.push_back({light_samples[k], mean_of_halves(a.variance, b.variance, goldens_),
                     seconds_of(a, b), mean_of(products(a.mean, b.mean, 1)),
                     static_cast<double>(a.rays) / static_cast<double>(a.all_samples())});
  }
  return tried;
}

std::vector<Study::PixelNoise> Study::pixel_noise(const Way& way, int light_samples) {
  const pt::View view = view_of(way, light_samples);
  const RenderedPixels measured =
      made(view, next_render(samples_in(2 * kOfOneRender * limits_.seconds, view)), pixels_);
  std::vector<PixelNoise> noise;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const double v = measured.variance[i], g = measured.mean[i];
    noise.push_back({v * goldens_.weight(i), g > 0 ? v / (g * g) : 0});
  }
  return noise;
}

Checked Study::check(const pt::PathSettings& path, const pt::RenderSettings& settings,
                     double seconds, const std::optional<Uncertain>& bias2, double part) {
  const double fit = cpu_seconds_in(part * limits_.seconds) / (2 * seconds);
  const std::size_t wanted = std::max<std::size_t>(kFewestPixels, static_cast<std::size_t>(fit));
  const std::size_t step = std::max<std::size_t>(1, pixels_.size() / wanted);
  const std::vector<PixelAt> some = every(step);
  const pt::View view{view_.scene, view_.camera, path, view_.width, view_.height};
  RenderedPixels pictures[2];
  for (RenderedPixels& picture : pictures) {
    pt::RenderSettings render = next_render(settings.samples);
    render.adaptive = settings.adaptive;
    picture = made(view, render, some);
  }
  const std::vector<double>&x = pictures[0].mean, &y = pictures[1].mean;
  const std::vector<double> biases = products(x, y, step);
  std::vector<double> squares, noise;
  double black_samples = 0, black_pixels = 0;
  for (std::size_t k = 0; k < some.size(); ++k) {
    const std::size_t i = k * step;
    const double half = goldens_.weight(i) * (x[k] - y[k]) * (x[k] - y[k]) / 2;
    squares.push_back(half + (bias2 ? bias2->value : biases[k]));
    noise.push_back(goldens_.weight(i) / 2 *
                    (pictures[0].variance[k] / pictures[0].samples[k] +
                     pictures[1].variance[k] / pictures[1].samples[k]));
    if (goldens_.mean(i) > 0) continue;
    ++black_pixels;
    black_samples += pictures[0].samples[k] + pictures[1].samples[k];
  }
  Uncertain square = mean_of(squares);
  if (bias2) square.error = std::hypot(square.error, bias2->error);
  const auto n = static_cast<double>(2 * some.size());
  const auto samples = static_cast<double>(pictures[0].all_samples() + pictures[1].all_samples());
  return {pt::root_of(square),
          (pictures[0].cpu_seconds + pictures[1].cpu_seconds) / n,
          samples / n,
          static_cast<double>(pictures[0].rays + pictures[1].rays) / n,
          some.size(),
          mean_of(biases),
          pt::pixel_errors(std::move(noise)),
          2 * black_pixels / n,
          black_samples / samples};
}

Uncertain Study::times_as_long(const pt::Scene& other, const Way& way, int light_samples) {
  const pt::View here = view_of(way, light_samples);
  const pt::View there{other, here.camera, here.settings, here.width, here.height};
  // The other engine may be so slow that only few pixels are possible.
  const std::vector<PixelAt> few = every(pixels_.size() / kFewestPixels);
  const double one =
      made(there, next_render(2), few).cpu_seconds / (2.0 * static_cast<double>(few.size()));
  const double fit = cpu_seconds_in(kOfOneRender * limits_.seconds) / one;  // samples of pixels
  const std::size_t step =
      static_cast<std::size_t>(static_cast<double>(pixels_.size()) / std::max(1.0, fit / 2));
  const std::vector<PixelAt> some = every(std::min(step, pixels_.size() / kFewestPixels));
  const double each = std::min(fit / static_cast<double>(some.size()), double{kMaxTried});
  const int samples = std::max(2, static_cast<int>(each));
  std::vector<double> factors;
  for (int turn = 0; turn < kTurns; ++turn) {
    const pt::RenderSettings render = next_render(samples);
    const double seconds = made(here, render, some).cpu_seconds;
    factors.push_back(made(there, render, some).cpu_seconds / seconds);
  }
  return mean_of(factors);
}

std::vector<double> Study::products(const std::vector<double>& a, const std::vector<double>& b,
                                    std::size_t step) const {
  std::vector<double> all;
  for (std::size_t k = 0; k < a.size(); ++k) {
    all.push_back(goldens_.product(k * step, a[k], b[k]));
  }
  return all;
}

std::vector<PixelAt> Study::every(std::size_t step) const {
  std::vector<PixelAt> some;
  for (std::size_t i = 0; i < pixels_.size(); i += std::max<std::size_t>(1, step)) {
    some.push_back(pixels_[i]);
  }
  return some;
}

pt::RenderSettings Study::next_render(int samples) { return {samples, {}, ++seed_, threads_}; }

pt::View Study::view_of(const Way& way, int light_samples) const {
  return {view_.scene, view_.camera, path_of(way, light_samples), view_.width, view_.height};
}

int Study::samples_in(double seconds, const Cost& cpu_seconds) {
  if (limits_.samples > 0) return limits_.samples;
  const std::vector<PixelAt> some = every(8);
  const double one = cpu_seconds(next_render(2), some) / (2 * static_cast<double>(some.size()));
  const double fit = cpu_seconds_in(seconds) / (one * static_cast<double>(pixels_.size()));
  return std::clamp(static_cast<int>(std::min(fit, 1e6)) / 2 * 2, kFewestTried, kMaxTried);
}

int Study::samples_in(double seconds, const pt::View& view) {
  return samples_in(seconds,
                    [&](const pt::RenderSettings& settings, std::span<const PixelAt> some) {
                      return made(view, settings, some).cpu_seconds;
                    });
}

}  // namespace measure::scene
