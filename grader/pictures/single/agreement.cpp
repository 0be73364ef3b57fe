#include "grader/pictures/single/agreement.h"

#include "grader/base/normal.h"
#include "grader/pictures/statistics/blocks.h"
#include "pt/math/uncertain.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace grader::pictures {
namespace {

// Margins: parts of the mean that nobody is told of, by side; and a thousandth of the whole picture's mean.
constexpr std::array kMargins{.02, .01, .005};
constexpr double kDark = 1e-3;

// The evidence has to exceed the largest of our own pictures by this factor.
constexpr double kBeyondOurs = 1.3;

// Beyond so much evidence our own pictures are not asked.
constexpr double kBeyondDoubt = 20;

// Where most pixels are black or one code, and few are bright, neighbours do not show the noise. Then a picture may have as much as any.
constexpr double kLeastNoise = 0.1;

constexpr std::size_t kForNoise = 5;  // of our pictures, whose noise is looked at

constexpr double kMedianOfChiSquare = 0.4549;  // one degree of freedom

std::vector<double> luminances(const pt::Image& image) {
  std::vector<double> all;
  for (const pt::Rgb& pixel : image.pixels) all.push_back(luminance(pixel));
  return all;
}

// The mean over the pixels at most `reach` away, inside the picture.
std::vector<double> blurred(const std::vector<double>& values, int width, int height, int reach) {
  std::vector<double> sums(static_cast<std::size_t>(width + 1) * (height + 1));
  const auto sum = [&](int x, int y) -> double& {
    return sums[static_cast<std::size_t>(y) * (width + 1) + x];
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      sum(x + 1, y + 1) = values[static_cast<std::size_t>(y) * width + x] + sum(x, y + 1) +
                          sum(x + 1, y) - sum(x, y);
    }
  }
  std::vector<double> out(values.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int x0 = std::max(x - reach, 0), x1 = std::min(x + reach + 1, width);
      const int y0 = std::max(y - reach, 0), y1 = std::min(y + reach + 1, height);
      out[static_cast<std::size_t>(y) * width + x] =
          (sum(x1, y1) - sum(x0, y1) - sum(x1, y0) + sum(x0, y0)) / ((x1 - x0) * (y1 - y0));
    }
  }
  return out;
}

// The variance of a picture between neighbours, in which a difference over a larger part cancels, over what `variance` says.
double noise_of(const std::vector<double>& off, const std::vector<double>& variance, int width) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i + 1 < off.size(); ++i) {
    const double expected = variance[i] + variance[i + 1];
    if ((i + 1) % width == 0 || !(expected > 0)) continue;
    const double step = off[i] - off[i + 1];
    ratios.push_back(step * step / expected);
  }
  if (ratios.empty()) return 0;
  return pt::median_of(ratios) / kMedianOfChiSquare;
}

struct Sums {
  double difference = 0, variance = 0, mean = 0, blur = 0, step = 0, clipped = 0;
};

Sums sums_of(const SingleBlock& block, const OwnPictures& own, const std::vector<double>& off,
             const std::vector<double>& mean) {
  Sums sums;
  for (int y = block.y; y < block.y + block.height; ++y) {
    for (int x = block.x; x < block.x + block.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * own.width + x;
      sums.difference += off[i];
      sums.variance += own.variance[i];
      sums.mean += mean[i];
      sums.blur += own.filtered[i];
      if (!own.step.empty()) sums.step += own.step[i];
      sums.clipped += own.clipped[i];
    }
  }
  return sums;
}

// The number of standard deviations that a block of this side may be off by.
double threshold_of(const OwnPictures& own, int side) {
  int blocks = 0;
  for_each_block(own.width, own.height, side, [&](int, int, int, int) { ++blocks; });
  return base::normal_quantile_above(kSingleLevel / kSingleSides.size() / blocks / 2);
}

// The evidence of each side is divided by `farthest` where that is more than 1.
Agreement measured(const pt::Image& picture, const OwnPictures& own,
                   const std::vector<double>& mean, double pictures,
                   const std::array<double, kSingleSides.size()>& farthest) {
  std::vector<double> off = luminances(picture);
  for (std::size_t i = 0; i < off.size(); ++i) off[i] -= mean[i];
  Agreement result;
  const bool shows_noise = own.noise > kLeastNoise;
  result.noise = shows_noise ? noise_of(off, own.variance, own.width) / own.noise : kMostNoise;
  const double noise = std::max(result.noise, 1.0);
  double total = 0;
  for (const double each : mean) total += each;
  const double dark = kDark * total / static_cast<double>(mean.size());
  for (std::size_t k = 0; k < kSingleSides.size(); ++k) {
    const int side = kSingleSides[k];
    const double threshold = threshold_of(own, side) * std::max(1.0, farthest[k]);
    for_each_block(own.width, own.height, side, [&](int x, int y, int width, int height) {
      SingleBlock block{x, y, width, height, side};
      const Sums sums = sums_of(block, own, off, mean);
      const double pixels = static_cast<double>(width) * height;
      // A picture with less noise than ours loses less by clipping, one with more loses more.
      const double shift =
          shows_noise ? (1 - std::min(result.noise, kMostNoise)) * sums.clipped : 0;
      // Another filter moves light over the border of a block, another rounding moves it by a part of a code.
      const double margin = kMargins[k] * sums.mean + dark * pixels + std::abs(sums.blur) +
                            0.25 * sums.step + 0.5 * (std::abs(sums.clipped) + std::abs(shift));
      const double sigma = std::sqrt(sums.variance * (noise + 1 / pictures));
      const double bright = std::max(sums.mean, dark * pixels);
      const double beyond = std::max(0.0, std::abs(sums.difference - shift) - margin);
      if (k == 0 && sigma > 0) {
        result.distance += sums.difference * sums.difference / (sigma * sigma);
      }
      block.off_by = sums.difference / bright;
      block.evidence = beyond == 0 ? 0 : beyond / std::max(threshold * sigma, 1e-12);
      block.would_be_found = (margin + threshold * sigma) / bright;
      result.blocks.push_back(block);
      if (block.evidence > result.worst.evidence || result.blocks.size() == 1) result.worst = block;
    });
  }
  return result;
}

// One of our pictures against all others.
Agreement against_the_others(const OwnPictures& own, std::size_t one) {
  const double count = static_cast<double>(own.pictures.size());
  std::vector<double> others = luminances(own.mean);
  for (std::size_t i = 0; i < others.size(); ++i) {
    others[i] = (count * others[i] - luminance(own.pictures[one].pixels[i])) / (count - 1);
  }
  return measured(own.pictures[one], own, others, count - 1, {});
}

// The most evidence that one of ours has against the others, by side, with what a picture of somebody else may exceed it by.
std::array<double, kSingleSides.size()> farthest_of(const OwnPictures& own) {
  std::array<double, kSingleSides.size()> farthest{};
  for (std::size_t one = 0; one < own.pictures.size(); ++one) {
    for (const SingleBlock& block : against_the_others(own, one).blocks) {
      const std::size_t k = std::ranges::find(kSingleSides, block.side) - kSingleSides.begin();
      farthest[k] = std::max(farthest[k], kBeyondOurs * block.evidence);
    }
  }
  return farthest;
}

}  // namespace

OwnPictures own_pictures(std::vector<pt::Image> pictures, const CodecMeans& means, double taken) {
  assert(pictures.size() >= 8);
  OwnPictures own;
  own.taken = taken;
  own.width = pictures[0].width;
  own.height = pictures[0].height;
  own.mean = mean_of(pictures);
  own.step = means.steps;
  const double count = static_cast<double>(pictures.size());
  std::vector<double> raw(own.mean.pixels.size());
  for (std::size_t i = 0; i < raw.size(); ++i) {
    double y = 0, squares = 0;
    for (const pt::Image& picture : pictures) {
      y += luminance(picture.pixels[i]) / count;
    }
    for (const pt::Image& picture : pictures) {
      const double off = luminance(picture.pixels[i]) - y;
      squares += off * off;
    }
    raw[i] = squares / (count - 1);
  }
  const std::vector<double> near = blurred(raw, own.width, own.height, 5);
  own.variance.resize(raw.size());
  for (std::size_t i = 0; i < raw.size(); ++i) {
    own.variance[i] = 0.5 * raw[i] + 0.5 * near[i];
    if (!own.step.empty()) own.variance[i] += own.step[i] * own.step[i] / 12;
  }
  own.pictures = std::move(pictures);
  const std::vector<double> mean = luminances(own.mean);
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const double quiet = luminance(means.quiet.pixels[i]);
    own.clipped.push_back(quiet - mean[i]);
    own.filtered.push_back(quiet - luminance(means.soft.pixels[i]));
  }
  std::vector<double> noises;
  for (std::size_t k = 0; k < kForNoise; ++k) noises.push_back(against_the_others(own, k).noise);
  own.noise = pt::median_of(noises);
  return own;
}

pt::Image softened(const pt::Image& image) {
  pt::Image soft(image.width, image.height);
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<double> values;
    for (const pt::Rgb& pixel : image.pixels) values.push_back(pixel[channel]);
    values = blurred(values, image.width, image.height, 1);
    for (std::size_t i = 0; i < values.size(); ++i) soft.pixels[i][channel] = values[i];
  }
  return soft;
}

pt::Image mean_of(const std::vector<pt::Image>& pictures) {
  pt::Image mean(pictures[0].width, pictures[0].height);
  for (const pt::Image& picture : pictures) {
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
      mean.pixels[i] += picture.pixels[i] / static_cast<double>(pictures.size());
    }
  }
  return mean;
}

Agreement compare(const pt::Image& picture, const OwnPictures& own) {
  const auto against = [&](const std::array<double, kSingleSides.size()>& farthest) {
    return measured(picture, own, luminances(own.mean),
                    static_cast<double>(own.pictures.size()) * own.taken, farthest);
  };
  Agreement first = against({});
  if (first.agrees() || first.worst.evidence > kBeyondDoubt) return first;
  return against(farthest_of(own));
}

}  // namespace grader::pictures
