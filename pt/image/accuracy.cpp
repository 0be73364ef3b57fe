#include "pt/image/accuracy.h"

#include "pt/image/compare.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pt {

std::vector<double> luminances(const Film& film) {
  std::vector<double> all;
  all.reserve(film.pixels.size());
  for (const FilmPixel& pixel : film.pixels) all.push_back(luminance(pixel.mean));
  return all;
}

Goldens::Goldens(std::vector<double> a, std::vector<double> b)
    : a_(std::move(a)), b_(std::move(b)) {
  const double sum =
      std::accumulate(b_.begin(), b_.end(), std::accumulate(a_.begin(), a_.end(), 0.0));
  dark_ = dark_of(sum / static_cast<double>(2 * std::max<std::size_t>(size(), 1)));
}

Uncertain root_of(const Uncertain& square) {
  const double root = std::sqrt(std::max(square.value, square.error));
  return {root, root > 0 ? square.error / (2 * root) : 0};
}

bool Accuracy::is_wrong() const {
  return noise && (bias2.value > kSignificant * bias2.error ||
                   std::abs(bias.value) > kSignificant * bias.error);
}

namespace {

// The mean signed error over the mean of g / (g + d), as the ratio of two sums over the pixels.
Uncertain bias_of(const std::vector<double>& picture, const Goldens& goldens) {
  double errors = 0, parts = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    errors += goldens.signed_error(i, picture[i]);
    parts += goldens.mean(i) / goldens.scale(i);
  }
  if (!(parts > 0)) return {};
  const double bias = errors / parts;
  double squares = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const double rest =
        goldens.signed_error(i, picture[i]) - bias * goldens.mean(i) / goldens.scale(i);
    squares += rest * rest;
  }
  return {bias, std::sqrt(squares) / parts};
}

}  // namespace

Accuracy accuracy_of(const std::vector<double>& picture, const std::vector<double>& variances,
                     const Goldens& goldens) {
  std::vector<double> squares, noise, rest;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    squares.push_back(goldens.product(i, picture[i], picture[i]));
    if (variances.empty()) continue;
    noise.push_back(goldens.weight(i) * variances[i]);
    rest.push_back(squares[i] - noise[i]);
  }
  Accuracy result{root_of(mean_of(squares)), {}, {}, bias_of(picture, goldens)};
  if (variances.empty()) return result;
  result.noise = root_of(mean_of(noise));
  result.bias2 = mean_of(rest);
  return result;
}

}  // namespace pt
