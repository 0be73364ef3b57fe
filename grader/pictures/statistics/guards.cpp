#include "grader/pictures/statistics/guards.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace grader::pictures {
namespace {

constexpr double kConstantTolerance = 1e-3;
constexpr int kFewestBatches = 3;

// The mean of min(z^2, 1), where z is a pixel's distance from the golden in standard errors of the
// golden. It is 0.516 for a picture without noise, more with noise. Its deviation over a hundred pixels
// is 0.040, so that the limit is 6 deviations below.
constexpr double kNearest = 0.25;
constexpr int kFewestPixels = 100;

// Two right batches are alike less often than with this chance.
constexpr double kLogChanceAlike = -23;  // 1e-10

// The logarithm of an upper estimate of the chance that two independent batches are alike at every
// pixel. A sample is either zero or one fixed value, with the golden's mean and variance: no
// distribution repeats itself more.
double log_chance_alike(const Golden& golden, int samples) {
  double log_chance = 0;
  for (std::size_t i = 0; i < golden.samples.size(); ++i) {
    const double mean = golden.mean[kLuminance][i];
    const double square = mean * mean + golden.variance[kLuminance][i];
    if (golden.constant[i] || !(square > 0)) continue;
    const double hit = mean * mean / square;
    const double rare = std::min({hit, 1 - hit, 0.5 / samples});
    log_chance += samples * std::log1p(-std::max(0.0, rare));
  }
  return log_chance;
}

std::optional<Unusable> bad_value(const pt::Image& image) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const pt::Rgb& color = image.pixels[i];
    const int x = static_cast<int>(i) % image.width, y = static_cast<int>(i) / image.width;
    if (!is_finite(color)) {
      return Unusable{fmt::format("pixel ({}, {}) is not a number: {}, {}, {}", x, y, color.r,
                                  color.g, color.b),
                      i};
    }
    if (std::min({color.r, color.g, color.b}) < 0) {
      return Unusable{fmt::format("pixel ({}, {}) has negative radiance: {:.4g}, {:.4g}, {:.4g}", x,
                                  y, color.r, color.g, color.b),
                      i};
    }
  }
  return {};
}

bool two_alike(const std::vector<pt::Image>& images) {
  for (std::size_t a = 0; a < images.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (images[a].pixels == images[b].pixels) return true;
    }
  }
  return false;
}

bool has_one_color(const pt::Image& image) {
  return std::ranges::all_of(
      image.pixels, [first = image.pixels.at(0)](const pt::Rgb& color) { return color == first; });
}

double sum_of(const pt::Image& image, const Plane& weights) {
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * luminance(image.pixels[i]);
  return sum;
}

struct Spread {
  double mean = 0;
  double variance = 0;
};

// The spread of a weighted sum between the batches.
Spread spread_of(const std::vector<pt::Image>& images, const Plane& weights) {
  Spread spread;
  double squares = 0;
  int count = 0;
  for (const pt::Image& image : images) {
    const double sum = sum_of(image, weights);
    const double step = sum - spread.mean;
    spread.mean += step / ++count;
    squares += step * (sum - spread.mean);
  }
  spread.variance = squares / (count - 1);
  return spread;
}

}  // namespace

std::optional<Unusable> unusable(const Golden& golden, const Batches& batches, int asked) {
  if (static_cast<int>(batches.images.size()) != asked) {
    return Unusable{fmt::format("there are {} pictures, and not {}", batches.images.size(), asked),
                    {}};
  }
  for (const pt::Image& image : batches.images) {
    if (image.width != golden.width || image.height != golden.height ||
        image.pixels.size() != golden.samples.size()) {
      return Unusable{fmt::format("the picture is {} x {}, and not {} x {}", image.width,
                                  image.height, golden.width, golden.height),
                      {}};
    }
  }
  for (const pt::Image& image : batches.images) {
    if (auto bad = bad_value(image)) return bad;
  }
  if (log_chance_alike(golden, batches.samples) < kLogChanceAlike && two_alike(batches.images)) {
    if (std::ranges::all_of(batches.images, has_one_color)) {
      const bool black = batches.images[0].pixels[0] == pt::Rgb{};
      return Unusable{black ? "the whole picture is black" : "every pixel has the same color", {}};
    }
    return Unusable{
        "two batches of samples were identical: the random numbers begin again, or are not used, "
        "or the points are the same for every batch",
        {}};
  }
  return {};
}

WrongConstant constant_error(const Golden& golden, const Moments& round, std::size_t i) {
  WrongConstant worst{i, 0, 0, 0, -1};
  for (int plane = 0; plane < kPlanes; ++plane) {
    const double bright = std::max(golden.mean[plane][i], golden.scale[plane]);
    const double difference = round.mean[plane][i] - golden.mean[plane][i];
    const double allowed = kConstantTolerance * bright;
    const double evidence = difference == 0 ? 0 : std::abs(difference) / allowed;
    if (evidence > worst.evidence) {
      const double mean = std::max(golden.mean[plane][i], 1e-3 * golden.scale[plane]);
      worst = {i, plane, difference, difference / mean, evidence};
    }
  }
  return worst;
}

std::vector<WrongConstant> wrong_constants(const Golden& golden, const Moments& round,
                                           const std::vector<pt::Image>& images) {
  std::vector<WrongConstant> found;
  for (std::size_t i = 0; i < golden.samples.size(); ++i) {
    if (!golden.constant[i]) continue;
    const WrongConstant error = constant_error(golden, round, i);
    if (error.evidence <= 1) continue;
    const double mean = golden.mean[error.plane][i];
    const double allowed = std::abs(error.difference) / error.evidence;
    const auto off = std::count_if(images.begin(), images.end(), [&](const pt::Image& image) {
      return !(std::abs(value(image.pixels[i], error.plane) - mean) <= allowed);
    });
    if (off >= std::min(kFewestBatches, round.batches)) found.push_back(error);
  }
  return found;
}

bool is_too_near(const Comparison& pictures) {
  double sum = 0;
  int pixels = 0;
  for (std::size_t i = 0; i < pictures.golden.samples.size(); ++i) {
    const double error = pictures.golden_error[kLuminance][i];
    if (pictures.golden.constant[i] || !(error > 0)) continue;
    const double off = pictures.difference[kLuminance][i];
    sum += std::min(off * off / error, 1.0);
    ++pixels;
  }
  return pixels >= kFewestPixels && sum < kNearest * pixels;
}

Noise measure_noise(const Golden& golden, const Moments& round,
                    const std::vector<pt::Image>& images) {
  double ratio = 0, independent = 0, pixels = 0, energy = 0;
  for (std::size_t i = 0; i < golden.samples.size(); ++i) {
    if (golden.constant[i]) continue;
    const double own = round.variance[kLuminance][i], expected = golden.variance[kLuminance][i];
    ++pixels;
    if (expected > 0) ratio += own * round.samples / expected;
    independent += golden.weighted[i] * golden.weighted[i] * own;
    energy += golden.mean[kLuminance][i];
  }
  Noise noise;
  if (pixels == 0) return noise;
  noise.ratio = ratio / pixels;
  const Spread weighted = spread_of(images, golden.weighted);
  if (independent > 0) noise.correlation = weighted.variance / independent;
  const Spread plain = spread_of(images, golden.plain);
  const double error = plain.mean - energy;
  if (energy > 0) noise.energy_off = error / energy;
  if (plain.variance > 0) noise.energy_t = error / std::sqrt(plain.variance / round.batches);
  return noise;
}

}  // namespace grader::pictures
