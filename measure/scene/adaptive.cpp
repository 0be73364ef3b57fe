#include "measure/scene/adaptive.h"

#include <algorithm>
#include <cmath>

namespace measure::scene {

namespace {

constexpr double kConfidence = 1.96;  // of adaptive_pixel

}  // namespace

std::vector<double> adaptive_samples(const std::vector<Study::PixelNoise>& noise,
                                     const pt::AdaptiveSettings& s) {
  std::vector<double> samples;
  for (const Study::PixelNoise& pixel : noise) {
    const double wanted =
        std::ceil(pixel.over_square * std::pow(kConfidence / s.tolerance, 2) / s.batch) * s.batch;
    samples.push_back(std::clamp(wanted, double(s.batch), double(s.max_samples)));
  }
  return samples;
}

double relmse_with(const std::vector<Study::PixelNoise>& noise,
                   const std::vector<double>& samples) {
  double sum = 0;
  for (std::size_t i = 0; i < noise.size(); ++i) sum += noise[i].relative / samples[i];
  return sum / static_cast<double>(noise.size());
}

double best_possible(const std::vector<Study::PixelNoise>& noise) {
  double roots = 0, squares = 0;
  for (const Study::PixelNoise& pixel : noise) {
    roots += std::sqrt(pixel.relative);
    squares += pixel.relative;
  }
  return squares > 0 ? roots * roots / squares / static_cast<double>(noise.size()) : 1;
}

double tolerance_for(const std::vector<Study::PixelNoise>& noise, pt::AdaptiveSettings settings,
                     double error2) {
  double low = 1e-4, high = 1;
  for (int i = 0; i < 40; ++i) {
    settings.tolerance = std::sqrt(low * high);
    (relmse_with(noise, adaptive_samples(noise, settings)) < error2 ? low : high) =
        settings.tolerance;
  }
  return std::sqrt(low * high);
}

}  // namespace measure::scene
