#pragma once

#include "pt/math/rgb.h"
#include "tests/proof/statistics.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Compares two pictures of one scene by a z for each pixel, each block and each sum over the
// picture. It uses the larger of the two variances, so that too few or too many bright samples in
// one picture are not taken for an error. No margin is added, because both pictures are right or
// one is wrong. The level is divided by the number of comparisons (Bonferroni).

namespace pt::proof {

// One channel or the luminance: mean and variance of each pixel's samples.
struct Plane {
  int width = 0, height = 0;
  std::vector<Running> pixels;

  Plane(int width_, int height_) : width(width_), height(height_), pixels(width_ * height_) {}
};

struct Picture {
  Plane luminance, r, g, b;

  Picture(int width, int height)
      : luminance(width, height), r(width, height), g(width, height), b(width, height) {}

  void add(int pixel, Rgb value) {
    luminance.pixels[pixel].add(pt::luminance(value));
    r.pixels[pixel].add(value.r);
    g.pixels[pixel].add(value.g);
    b.pixels[pixel].add(value.b);
  }
};

struct Worst {
  double z = 0;
  int comparisons = 0;

  void add(double other) {
    if (!(std::abs(other) <= std::abs(z))) z = other;  // also if z is NaN
    ++comparisons;
  }
};

// Returns z of the weighted difference. Pixels without variance are left out.
inline double z_of(const Plane& a, const Plane& golden, const std::vector<double>& weights) {
  double difference = 0, own = 0, expected = 0, of_golden = 0;
  for (std::size_t p = 0; p < weights.size(); ++p) {
    const Running &x = a.pixels[p], &g = golden.pixels[p];
    const double w = weights[p], n = static_cast<double>(x.n);
    difference += w * (x.mean - g.mean);
    own += w * w * x.variance() / n;
    expected += w * w * g.variance() / n;
    of_golden += w * w * g.variance() / static_cast<double>(g.n);
  }
  const double variance = std::max(own, expected) + of_golden;
  return variance > 0 ? difference / std::sqrt(variance) : difference == 0 ? 0 : HUGE_VAL;
}

inline void add_blocks(const Plane& a, const Plane& golden, int size, Worst& worst) {
  for (int y = 0; y < a.height; y += size) {
    for (int x = 0; x < a.width; x += size) {
      std::vector<double> weights(a.pixels.size());
      for (int j = y; j < std::min(y + size, a.height); ++j) {
        for (int i = x; i < std::min(x + size, a.width); ++i) weights[j * a.width + i] = 1;
      }
      worst.add(z_of(a, golden, weights));
    }
  }
}

// The plain mean, and a mean with larger weights for quiet pixels: w = g / (v + median(v) / 20).
inline void add_sums(const Plane& a, const Plane& golden, Worst& worst) {
  std::vector<double> variances, weights;
  for (const Running& pixel : golden.pixels) variances.push_back(pixel.variance());
  std::nth_element(variances.begin(), variances.begin() + variances.size() / 2, variances.end());
  const double median = variances[variances.size() / 2];
  for (const Running& pixel : golden.pixels) {
    weights.push_back(pixel.mean / (pixel.variance() + 0.05 * median));
  }
  worst.add(z_of(a, golden, weights));
  worst.add(z_of(a, golden, std::vector<double>(a.pixels.size(), 1)));
}

inline void expect_same_picture(const Picture& a, const Picture& golden, const std::string& what) {
  Worst worst;
  for (const int size : {1, 4, 8}) add_blocks(a.luminance, golden.luminance, size, worst);
  for (const auto channel : {&Picture::luminance, &Picture::r, &Picture::g, &Picture::b}) {
    add_blocks(a.*channel, golden.*channel, 24, worst);
    add_sums(a.*channel, golden.*channel, worst);
  }
  EXPECT_LE(std::abs(worst.z), two_sided_threshold(kLevel / worst.comparisons))
      << what << ", of " << worst.comparisons << " comparisons";
}

}  // namespace pt::proof
