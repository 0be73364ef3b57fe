#include "writeup/compose.h"

#include <algorithm>
#include <cmath>

namespace writeup {

namespace {

constexpr double kDark = 0.01;  // added to the divisor, as in pt/image/compare.h

void add(Rendered& sum, const Rendered& layer) {
  for (std::size_t i = 0; i < sum.film.pixels.size(); ++i) {
    pt::FilmPixel& into = sum.film.pixels[i];
    const pt::FilmPixel& from = layer.film.pixels[i];
    into.mean += from.mean;
    into.variance_y += from.variance_y;
    into.samples = std::min(into.samples, from.samples);
    sum.boxes[i] += layer.boxes[i];
  }
  sum.seconds += layer.seconds;
  sum.total.rays += layer.total.rays;
  sum.total.not_finite += layer.total.not_finite;
  sum.has_variance = sum.has_variance && layer.has_variance;
  sum.missing.insert(sum.missing.end(), layer.missing.begin(), layer.missing.end());
  if (sum.failed.empty()) sum.failed = layer.failed;
}

// The variance of the mean of a pixel, over the square of the divisor of its errors.
double relative_variance(const pt::FilmPixel& pixel) {
  const double scale = pt::luminance(pixel.mean) + kDark;
  return pixel.variance_y / std::max(pixel.samples, 1) / (scale * scale);
}

}  // namespace

Composed compose(const Store& store, const std::vector<Unit>& units) {
  Composed result{store.load(units.at(0))};
  for (std::size_t i = 1; i < units.size(); ++i) add(result.sum, store.load(units[i]));
  for (const pt::FilmPixel& pixel : result.sum.film.pixels) result.rows += pixel.samples > 0;
  result.rows /= std::max(result.sum.film.width, 1);
  result.complete = result.rows == result.sum.film.height;
  return result;
}

double noise(const Rendered& picture) {
  double sum = 0;
  for (const pt::FilmPixel& pixel : picture.film.pixels) sum += relative_variance(pixel);
  return std::sqrt(sum / static_cast<double>(picture.film.pixels.size()));
}

double error(const Rendered& picture, const Rendered& golden) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.film.pixels.size(); ++i) {
    const pt::FilmPixel& right = golden.film.pixels[i];
    const double y = pt::luminance(right.mean);
    const double off = (pt::luminance(picture.film.pixels[i].mean) - y) / (y + kDark);
    sum += off * off - relative_variance(right);
  }
  return std::sqrt(std::max(0.0, sum) / static_cast<double>(picture.film.pixels.size()));
}

double mean_luminance(const pt::Film& film) {
  double sum = 0;
  for (const pt::FilmPixel& pixel : film.pixels) sum += pt::luminance(pixel.mean);
  return sum / static_cast<double>(film.pixels.size());
}

std::vector<int> predicted_samples(const pt::Film& uniform, const pt::AdaptiveSettings& settings) {
  std::vector<int> counts;
  for (const pt::FilmPixel& pixel : uniform.pixels) {
    const double y = pt::luminance(pixel.mean);
    const double ratio = 1.96 / (settings.tolerance * y);
    const double wanted = pixel.variance_y * ratio * ratio;
    // An adaptive render stops at the end of a batch, but never where it sees only black.
    const double batches = std::ceil(wanted / settings.batch);
    const bool stops = y > 0 && batches * settings.batch < settings.max_samples;
    counts.push_back(stops ? std::max(1, static_cast<int>(batches)) * settings.batch
                           : settings.max_samples);
  }
  return counts;
}

}  // namespace writeup
