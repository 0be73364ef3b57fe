#include "writeup/compose.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

}  // namespace

Composed compose(const Store& store, const std::vector<Unit>& units) {
  Composed result{store.load(units.at(0))};
  for (std::size_t i = 1; i < units.size(); ++i) add(result.sum, store.load(units[i]));
  for (const pt::FilmPixel& pixel : result.sum.film.pixels) result.rows += pixel.samples > 0;
  result.rows /= std::max(result.sum.film.width, 1);
  result.complete = result.rows == result.sum.film.height;
  return result;
}

Rendered cropped(const Rendered& whole, const Crop& crop) {
  const auto pixels = [](double part, int all) {
    return static_cast<int>(std::lround(part * all));
  };
  const pt::Film& film = whole.film;
  const int left = std::min(pixels(crop.left, film.width), film.width - 1);
  const int top = std::min(pixels(crop.top, film.height), film.height - 1);
  const int width = std::clamp(pixels(crop.width, film.width), 1, film.width - left);
  const int height = std::clamp(pixels(crop.height, film.height), 1, film.height - top);
  Rendered part = whole;
  part.film = pt::Film(width, height);
  part.boxes.clear();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      part.film.set(x, y, film.at(left + x, top + y));
      if (whole.boxes.empty()) continue;
      part.boxes.push_back(whole.boxes[static_cast<std::size_t>(top + y) * film.width + left + x]);
    }
  }
  return part;
}

std::optional<pt::Goldens> goldens_of(const Plan& plan, const Figure& figure,
                                      const std::optional<Crop>& crop) {
  std::vector<std::vector<double>> both;
  for (const Picture& golden : figure.goldens) {
    if (!plan.unavailable(golden).empty()) return {};
    const Composed composed = compose(plan.store(), plan.units(figure, golden));
    if (!composed.complete || !composed.sum.missing.empty()) return {};
    both.push_back(pt::luminances(crop ? cropped(composed.sum, *crop).film : composed.sum.film));
  }
  if (both.size() != 2) return {};
  return pt::Goldens(std::move(both[0]), std::move(both[1]));
}

pt::Accuracy accuracy(const Rendered& picture, const pt::Goldens& goldens) {
  std::vector<double> variances;
  // A single sample has no variance.
  const auto is_known = [](const pt::FilmPixel& pixel) { return pixel.samples > 1; };
  if (picture.has_variance && std::ranges::all_of(picture.film.pixels, is_known)) {
    for (const pt::FilmPixel& pixel : picture.film.pixels) variances.push_back(variance(pixel));
  }
  return pt::accuracy_of(pt::luminances(picture.film), variances, goldens);
}

pt::PixelErrors pixel_noise(const Rendered& picture, const pt::Goldens& goldens) {
  std::vector<double> squares;
  for (std::size_t i = 0; i < goldens.size(); ++i) {
    squares.push_back(goldens.weight(i) * variance(picture.film.pixels[i]));
  }
  return pt::pixel_errors(std::move(squares));
}

Black on_black(const Rendered& picture, const pt::Goldens& goldens) {
  double pixels = 0, samples = 0, all = 0;
  for (std::size_t i = 0; i < goldens.size(); ++i) {
    const int count = picture.film.pixels[i].samples;
    all += count;
    if (goldens.mean(i) > 0) continue;
    ++pixels;
    samples += count;
  }
  return {pixels / static_cast<double>(goldens.size()), samples / all};
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
