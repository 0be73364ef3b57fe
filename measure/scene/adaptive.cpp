#include "measure/scene/adaptive.h"

#include <algorithm>
#include <cmath>

namespace measure::scene {

namespace {

constexpr double kConfidence = 1.96;  // of adaptive_pixel

double adaptive_error2(const std::vector<Study::PixelNoise>& noise, const pt::AdaptiveSettings& s) {
  double sum = 0;
  for (const Study::PixelNoise& pixel : noise) {
    const double wanted =
        std::ceil(pixel.over_square * std::pow(kConfidence / s.tolerance, 2) / s.batch) * s.batch;
    sum += pixel.relative / std::clamp(wanted, double(s.batch), double(s.max_samples));
  }
  return sum / static_cast<double>(noise.size());
}

}  // namespace

double tolerance_for(const std::vector<Study::PixelNoise>& noise, pt::AdaptiveSettings settings,
                     double error2) {
  double low = 1e-4, high = 1;
  for (int i = 0; i < 40; ++i) {
    settings.tolerance = std::sqrt(low * high);
    (adaptive_error2(noise, settings) < error2 ? low : high) = settings.tolerance;
  }
  return std::sqrt(low * high);
}

}  // namespace measure::scene
