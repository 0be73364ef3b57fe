#include "writeup/compose.h"

#include <algorithm>
#include <cmath>

namespace writeup {

namespace {

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

// The variance of the mean of a pixel.
double variance(const pt::FilmPixel& pixel) {
  return pixel.variance_y / std::max(pixel.samples, 1);
}

// The divisors of the errors of pixels, where this is the picture without noise.
std::vector<double> scales(const Rendered& golden) {
  const double dark = pt::dark_of(mean_luminance(golden.film));
  std::vector<double> all;
  for (const pt::FilmPixel& pixel : golden.film.pixels) {
    all.push_back(pt::luminance(pixel.mean) + dark);
  }
  return all;
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
  const std::vector<double> scale = scales(picture);
  double sum = 0;
  for (std::size_t i = 0; i < scale.size(); ++i) {
    sum += variance(picture.film.pixels[i]) / (scale[i] * scale[i]);
  }
  return std::sqrt(sum / static_cast<double>(scale.size()));
}

double error(const Rendered& picture, const Rendered& golden) {
  const std::vector<double> scale = scales(golden);
  double sum = 0;
  for (std::size_t i = 0; i < scale.size(); ++i) {
    const pt::FilmPixel& right = golden.film.pixels[i];
    const double off = pt::luminance(picture.film.pixels[i].mean) - pt::luminance(right.mean);
    sum += (off * off - variance(right)) / (scale[i] * scale[i]);
  }
  return std::sqrt(std::max(0.0, sum) / static_cast<double>(scale.size()));
}

double bias(const Rendered& picture, const Rendered& golden) {
  const std::vector<double> scale = scales(golden);
  double sum = 0;
  for (std::size_t i = 0; i < scale.size(); ++i) {
    sum +=
        (pt::luminance(picture.film.pixels[i].mean) - pt::luminance(golden.film.pixels[i].mean)) /
        scale[i];
  }
  return sum / static_cast<double>(scale.size());
}

pt::PixelErrors pixel_noise(const Rendered& picture, const Rendered& golden) {
  const std::vector<double> scale = scales(golden);
  std::vector<double> squares;
  for (std::size_t i = 0; i < scale.size(); ++i) {
    squares.push_back(variance(picture.film.pixels[i]) / (scale[i] * scale[i]));
  }
  return pt::pixel_errors(std::move(squares));
}

Black on_black(const Rendered& picture, const Rendered& golden) {
  double pixels = 0, samples = 0, all = 0;
  for (std::size_t i = 0; i < golden.film.pixels.size(); ++i) {
    const int count = picture.film.pixels[i].samples;
    all += count;
    if (pt::luminance(golden.film.pixels[i].mean) > 0) continue;
    ++pixels;
    samples += count;
  }
  return {pixels / static_cast<double>(golden.film.pixels.size()), samples / all};
}

double mean_on_lamps(const pt::Film& film, const pt::Film& lamps) {
  constexpr double kWhole = 0.9;  // of the brightest: the lamp fills the pixel
  double sum = 0, brightest = 0;
  int count = 0;
  for (const pt::FilmPixel& pixel : lamps.pixels) {
    brightest = std::max(brightest, pt::luminance(pixel.mean));
  }
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    const double lamp = pt::luminance(lamps.pixels[i].mean);
    if (lamp == 0 || lamp < kWhole * brightest) continue;
    sum += pt::luminance(film.pixels[i].mean);
    ++count;
  }
  return count > 0 ? sum / count : 0;
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
