#include "grader/pictures/statistics/welch.h"

#include "grader/base/normal.h"
#include "grader/pictures/statistics/blocks.h"
#include "pt/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace grader::pictures {
namespace {

constexpr double kNineOfTen = 1.2816;  // of a normal distribution, nine tenths lie below this

template <class Value>
double sum_of(int width, int x0, int y0, int w, int h, const Value& value) {
  double sum = 0;
  for (int y = y0; y < y0 + h; ++y) {
    for (int x = x0; x < x0 + w; ++x) sum += value(static_cast<std::size_t>(y) * width + x);
  }
  return sum;
}

BlockDifference measured(const NoisyPicture& a, const NoisyPicture& b, BlockDifference block,
                         double floor, double level) {
  const int width = a.mean.width;
  const auto sum = [&](const auto& value) {
    return sum_of(width, block.x, block.y, block.width, block.height, value);
  };
  const double difference =
      sum([&](std::size_t i) { return luminance(a.mean.pixels[i]) - luminance(b.mean.pixels[i]); });
  const double pixels = static_cast<double>(block.width) * block.height;
  const double bright =
      std::max(sum([&](std::size_t i) { return luminance(b.mean.pixels[i]); }), floor * pixels);
  double variance = 0, squares = 0;
  for (const NoisyPicture* each : {&a, &b}) {
    variance += each->correlation * sum([&](std::size_t i) { return each->variance[i]; });
    squares += each->correlation * each->correlation * sum([&](std::size_t i) {
                 return each->variance[i] * each->variance[i] / each->freedom;
               });
  }
  block.off_by = bright > 0 ? difference / bright : 0;
  if (variance > 0) {
    block.p = student_p(difference / std::sqrt(variance), variance * variance / squares);
    block.would_be_found =
        (base::normal_quantile_above(level / 2) + kNineOfTen) * std::sqrt(variance) / bright;
  } else {
    block.p = difference == 0 ? 1 : 0;
  }
  return block;
}

bool is_inside(const BlockDifference& inner, const BlockDifference& outer) {
  return inner.x >= outer.x && inner.y >= outer.y &&
         inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

// The correlation of neighbours, as the sums of blocks show it between the pictures.
double correlation_of(const std::vector<pt::Image>& pictures, const NoisyPicture& all) {
  double of_sums = 0, of_pixels = 0;
  const double count = static_cast<double>(pictures.size());
  for_each_block(all.mean.width, all.mean.height, 8, [&](int x, int y, int w, int h) {
    const double mean = sum_of(all.mean.width, x, y, w, h,
                               [&](std::size_t i) { return luminance(all.mean.pixels[i]); });
    for (const pt::Image& picture : pictures) {
      const double off = sum_of(all.mean.width, x, y, w, h,
                                [&](std::size_t i) { return luminance(picture.pixels[i]); }) -
                         mean;
      of_sums += off * off / (count - 1) / count;
    }
    of_pixels += sum_of(all.mean.width, x, y, w, h, [&](std::size_t i) { return all.variance[i]; });
  });
  return of_pixels > 0 ? std::max(1.0, of_sums / of_pixels) : 1;
}

void require_finite(const pt::Image& image, const std::string& name) {
  for (const pt::Rgb& pixel : image.pixels) {
    if (!is_finite(pixel)) throw pt::Error(name + " has a pixel that is not finite");
  }
}

}  // namespace

double student_p(double t, double freedom) {
  if (std::isnan(t)) return 1;
  const double z =
      (8 * freedom + 1) / (8 * freedom + 3) * std::sqrt(freedom * std::log1p(t * t / freedom));
  return std::erfc(z / std::numbers::sqrt2);
}

NoisyPicture noisy_picture(const pt::Film& film, const std::string& name) {
  NoisyPicture picture{mean(film), {}, std::numeric_limits<double>::infinity(), 1};
  require_finite(picture.mean, name);
  for (const pt::FilmPixel& pixel : film.pixels) {
    if (pixel.samples < 2) {
      throw pt::Error(
          name + " has a pixel without a variance; give several pictures with commas between them");
    }
    picture.variance.push_back(pixel.variance_y / pixel.samples);
    picture.freedom = std::min(picture.freedom, pixel.samples - 1.0);
  }
  return picture;
}

NoisyPicture noisy_picture(const std::vector<pt::Image>& pictures) {
  if (pictures.size() < 2) throw pt::Error("one picture alone shows no noise; give several");
  NoisyPicture all{pt::Image(pictures[0].width, pictures[0].height),
                   {},
                   static_cast<double>(pictures.size()) - 1,
                   1};
  all.variance.resize(all.mean.pixels.size());
  for (const pt::Image& picture : pictures) {
    if (picture.width != all.mean.width || picture.height != all.mean.height) {
      throw pt::Error("pictures of one side have different sizes");
    }
    require_finite(picture, "a picture");
  }
  for (std::size_t i = 0; i < all.mean.pixels.size(); ++i) {
    pt::RunningMoments moments;
    for (const pt::Image& picture : pictures) moments.add(picture.pixels[i]);
    all.mean.pixels[i] = moments.mean();
    all.variance[i] = moments.variance_y() / moments.samples();
  }
  all.correlation = correlation_of(pictures, all);
  return all;
}

WelchTest welch_test(const NoisyPicture& a, const NoisyPicture& b) {
  if (a.mean.width != b.mean.width || a.mean.height != b.mean.height) {
    throw pt::Error("the pictures have different sizes");
  }
  double total = 0;
  for (const pt::Rgb& pixel : b.mean.pixels) total += luminance(pixel);
  const double floor =
      1e-3 * total / static_cast<double>(std::max<std::size_t>(b.mean.pixels.size(), 1));
  WelchTest test;
  for (const int side : kWelchSides) {
    std::vector<BlockDifference> places;
    for_each_block(a.mean.width, a.mean.height, side, [&](int x, int y, int w, int h) {
      places.push_back({x, y, w, h, side});
    });
    const double level = kWelchLevel / kWelchSides.size() / static_cast<double>(places.size());
    for (const BlockDifference& place : places) {
      const BlockDifference block = measured(a, b, place, floor, level);
      test.blocks.push_back(block);
      const bool is_said = std::ranges::any_of(
          test.differing, [&](const BlockDifference& other) { return is_inside(other, block); });
      if (block.p < level && !is_said) test.differing.push_back(block);
    }
  }
  std::ranges::stable_sort(test.differing, {}, &BlockDifference::p);
  return test;
}

}  // namespace grader::pictures
