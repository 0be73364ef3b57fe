#include "grader/pictures/block_means.h"

#include "grader/base/normal.h"
#include "pt/error.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

namespace grader::pictures {
namespace {

constexpr int kSide = 8;  // pixels
// The part by which rounding, another order of additions or pi to six digits may change a mean.
constexpr double kOfMean = 2e-3, kOfBright = 5e-4;
// Levels for all values together: for the largest, and, over all planes, for their sums of squares and their means.
constexpr double kLargestLevel = 4e-4, kSquaresLevel = 3e-4, kMeanLevel = 2e-4;

constexpr std::string_view kDigits =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz-_";
constexpr int kMeanDigits = 3, kErrorDigits = 2;
constexpr double kSmallest = 0x1p-40, kLargest = 0x1p24;

// Mean and variance of what `values` says of each pixel of a block, added up block by block.
struct BlockSums {
  double mean = 0, variance = 0, squares = 0;
  int pixels = 0;
};

template <class Values>
std::vector<BlockSums> sums(int width, int height, const Values& values) {
  const int columns = (width + kSide - 1) / kSide, rows = (height + kSide - 1) / kSide;
  std::vector<BlockSums> all(static_cast<std::size_t>(columns) * rows);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto [mean, variance] = values(static_cast<std::size_t>(y) * width + x);
      BlockSums& block = all[static_cast<std::size_t>(y / kSide) * columns + x / kSide];
      block.mean += mean;
      block.squares += mean * mean;
      block.variance += variance;
      ++block.pixels;
    }
  }
  return all;
}

// The logarithm of a value in as many digits; 0 where there is none.
std::string digits(double value, int count) {
  const double most = std::pow(64, count) - 1;
  double code = 0;
  if (value > 0) {
    const double inside = std::clamp(value, kSmallest, kLargest);
    code = 1 +
           std::round((most - 1) * std::log2(inside / kSmallest) / std::log2(kLargest / kSmallest));
  }
  auto rest = static_cast<unsigned>(code);
  std::string text(count, '0');
  for (int i = count - 1; i >= 0; --i, rest /= 64) text[i] = kDigits[rest % 64];
  return text;
}

double value_of(std::string_view text) {
  const double most = std::pow(64, static_cast<double>(text.size())) - 1;
  double code = 0;
  for (const char letter : text) {
    const std::size_t digit = kDigits.find(letter);
    if (digit == std::string_view::npos) throw pt::Error("the means of blocks are broken off");
    code = 64 * code + static_cast<double>(digit);
  }
  if (code == 0) return 0;
  return kSmallest * std::exp2((code - 1) / (most - 1) * std::log2(kLargest / kSmallest));
}

// The value that the sum of the squares of so many standard normal numbers exceeds with this
// probability (Wilson and Hilferty 1931).
double chi_square_above(double count, double probability) {
  const double part = 2 / (9 * count);
  const double root = 1 - part + base::normal_quantile_above(probability) * std::sqrt(part);
  return count * root * root * root;
}

// Distances of values from the right ones beyond the margin, in standard deviations.
struct Deviations {
  double largest = 0;
  double squares = 0;
  double of_mean = 0;  // over all blocks
};

double beyond(double difference, double margin, double variance) {
  const double excess = std::abs(difference) - margin;
  return excess <= 0 ? 0 : excess / std::sqrt(variance);
}

// Compares block by block: each difference over its standard deviation, from the larger of two variances, as in every
// verdict. `ratio`: the samples per pixel of `known` over those of `picture`.
Deviations deviations(const std::vector<BlockMean>& picture, const std::vector<BlockMean>& known,
                      double ratio) {
  const auto count = static_cast<double>(known.size());
  double bright = 0;
  for (const BlockMean& block : known) bright += block.mean / count;
  Deviations found;
  double difference = 0, variance = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const double margin = kOfMean * known[i].mean + kOfBright * bright;
    const double own = picture[i].error * picture[i].error;
    const double error = known[i].error * known[i].error;
    const double of_both = std::max(own, error * ratio) + error;
    const double z = beyond(picture[i].mean - known[i].mean, margin, of_both);
    found.largest = std::max(found.largest, z);
    found.squares += z * z;
    difference += picture[i].mean - known[i].mean;
    variance += of_both;
  }
  found.of_mean = beyond(difference, count * (kOfMean + kOfBright) * bright, variance);
  return found;
}

}  // namespace

BlockMeans block_means(const pt::Film& film) {
  BlockMeans blocks;
  if (!film.pixels.empty()) blocks.samples = film.pixels[0].samples;
  for (int channel = 0; channel < 3; ++channel) {
    auto& plane = blocks.planes.emplace_back();
    const auto all = sums(film.width, film.height, [&](std::size_t i) {
      const pt::FilmPixel& pixel = film.pixels[i];
      return std::pair{pixel.mean[channel], pixel.variance[channel] / pixel.samples};
    });
    for (const BlockSums& sum : all) {
      plane.push_back({sum.mean / sum.pixels, std::sqrt(sum.variance) / sum.pixels});
    }
  }
  return blocks;
}

void add_counts(BlockMeans& blocks, const pt::SampleMap& counts) {
  auto& plane = blocks.planes.emplace_back();
  const auto all = sums(counts.width, counts.height, [&](std::size_t i) {
    return std::pair{static_cast<double>(counts.counts[i]), 0.0};
  });
  for (const BlockSums& sum : all) {
    const double mean = sum.mean / sum.pixels;
    const double variance = std::max(0.0, sum.squares / sum.pixels - mean * mean);
    plane.push_back({mean, std::sqrt(variance / sum.pixels)});
  }
}

std::string to_text(const BlockMeans& blocks) {
  std::string text = std::to_string(blocks.samples);
  for (const auto& plane : blocks.planes) {
    text += ' ';
    for (const BlockMean& block : plane) {
      text += digits(block.mean, kMeanDigits) + digits(block.error, kErrorDigits);
    }
  }
  return text;
}

BlockMeans block_means_from(const std::string& text) {
  constexpr std::size_t kLength = kMeanDigits + kErrorDigits;
  BlockMeans blocks;
  std::istringstream in(text);
  if (!(in >> blocks.samples) || blocks.samples < 1) {
    throw pt::Error("the means of blocks begin with the samples per pixel");
  }
  for (std::string word; in >> word;) {
    auto& plane = blocks.planes.emplace_back();
    if (word.size() % kLength != 0) throw pt::Error("the means of blocks are broken off");
    for (std::size_t i = 0; i < word.size(); i += kLength) {
      const std::string_view both = std::string_view(word).substr(i, kLength);
      plane.push_back({value_of(both.substr(0, kMeanDigits)), value_of(both.substr(kMeanDigits))});
    }
  }
  return blocks;
}

bool can_be(const BlockMeans& picture, const BlockMeans& known) {
  constexpr std::size_t kChannels = 3;
  if (picture.planes.size() != known.planes.size()) return false;
  double values = 0;
  for (std::size_t i = 0; i < known.planes.size(); ++i) {
    if (picture.planes[i].size() != known.planes[i].size()) return false;
    values += static_cast<double>(known.planes[i].size());
  }
  const auto planes = static_cast<double>(known.planes.size());
  const double largest = base::normal_quantile_above(kLargestLevel / values / 2);
  for (std::size_t i = 0; i < known.planes.size(); ++i) {
    // Counts are of one run in both, whatever the samples are.
    const double ratio = i < kChannels ? static_cast<double>(known.samples) / picture.samples : 1;
    const Deviations off = deviations(picture.planes[i], known.planes[i], ratio);
    const auto count = static_cast<double>(known.planes[i].size());
    const double most = chi_square_above(count, kSquaresLevel / planes);
    const double most_of_mean = base::normal_quantile_above(kMeanLevel / planes / 2);
    if (!(off.largest <= largest && off.squares <= most && off.of_mean <= most_of_mean)) {
      return false;
    }
  }
  return true;
}

}  // namespace grader::pictures
