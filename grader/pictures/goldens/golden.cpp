#include "grader/pictures/goldens/golden.h"

#include "pt/error.h"
#include "pt/image/image_io.h"
#include "pt/math/uncertain.h"

#include <algorithm>
#include <cassert>
#include <filesystem>

namespace grader::pictures {
namespace {

// If the deviation of a sample, relative to the brightness there, is below this, it is rounding.
constexpr double kConstantDeviation = 1e-4;

// A channel may be black in the whole picture; this much of the luminance then counts as its
// brightness, so that a rounding error does not count as light.
constexpr double kBlackChannel = 1e-3;

constexpr int kReach = 2;  // pixels, to each side

bool is_constant(const Golden& golden, std::size_t i) {
  for (int plane = 0; plane < kPlanes; ++plane) {
    const double deviation =
        kConstantDeviation * std::max(golden.mean[plane][i], golden.scale[plane]);
    if (!(golden.variance[plane][i] <= deviation * deviation)) return false;
  }
  return true;
}

// The average of a plane over the pixels around one, without itself and without constant pixels; 0
// if there are none.
double around(const Golden& golden, const Plane& plane, int x, int y) {
  double sum = 0, count = 0;
  for (int v = std::max(0, y - kReach); v <= std::min(golden.height - 1, y + kReach); ++v) {
    for (int u = std::max(0, x - kReach); u <= std::min(golden.width - 1, x + kReach); ++u) {
      const std::size_t i = static_cast<std::size_t>(v) * golden.width + u;
      if ((u == x && v == y) || golden.constant[i]) continue;
      sum += plane[i];
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

// The weight is mean over variance, both of the neighbours. With its own, a pixel in which the
// golden has too many fireflies would weigh less, and a pixel with too few would weigh more. The
// golden's sum would be too dark, and every right picture would seem too bright.
void choose_weights(Golden& golden) {
  const std::size_t count = golden.samples.size();
  Plane variances;
  for (std::size_t i = 0; i < count; ++i) {
    if (!golden.constant[i]) variances.push_back(golden.variance[kLuminance][i]);
  }
  const double softening = variances.empty() ? 0 : 0.05 * pt::median_of(variances);
  golden.plain.assign(count, 0);
  golden.weighted.assign(count, 0);
  for (int y = 0; y < golden.height; ++y) {
    for (int x = 0; x < golden.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * golden.width + x;
      if (golden.constant[i]) continue;
      golden.plain[i] = 1;
      const double mean = around(golden, golden.mean[kLuminance], x, y);
      const double spread = around(golden, golden.variance[kLuminance], x, y) + softening;
      if (spread > 0) golden.weighted[i] = std::max(0.0, mean) / spread;
    }
  }
}

}  // namespace

pt::Film read_golden(const std::string& path, const Recipe& recipe) {
  if (!std::filesystem::exists(path)) {
    throw pt::Error(path + " is missing: make it with ./run bless " + recipe.name);
  }
  pt::Film golden = pt::read_exr(path);
  if (golden.width != recipe.width || golden.height != recipe.height) {
    throw pt::Error(path + " has the wrong size: make it with ./run bless " + recipe.name);
  }
  return golden;
}

Golden prepare(const pt::Film& film) {
  assert(film.width > 0 && film.height > 0);
  Golden golden;
  golden.width = film.width;
  golden.height = film.height;
  for (const pt::FilmPixel& pixel : film.pixels) {
    assert(pixel.samples >= 2);
    golden.samples.push_back(pixel.samples);
    for (int plane = 0; plane < kPlanes; ++plane) {
      const double mean = value(pixel.mean, plane);
      golden.mean[plane].push_back(mean);
      golden.scale[plane] += mean / static_cast<double>(film.pixels.size());
      golden.variance[plane].push_back(plane == kLuminance ? pixel.variance_y
                                                           : pixel.variance[plane]);
    }
  }
  for (double& scale : golden.scale) {
    scale = std::max(scale, kBlackChannel * golden.scale[kLuminance]);
  }
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    golden.constant.push_back(is_constant(golden, i) ? 1 : 0);
  }
  choose_weights(golden);
  return golden;
}

Moments moments(const std::vector<pt::Image>& images, int samples) {
  assert(images.size() >= 2);
  const std::size_t count = images[0].pixels.size();
  Moments result{static_cast<int>(images.size()), samples, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    pt::RunningMoments running;
    for (const pt::Image& image : images) running.add(image.pixels[i]);
    for (int plane = 0; plane < kPlanes; ++plane) {
      result.mean[plane].push_back(plane == kLuminance ? running.mean_y() : running.mean()[plane]);
      result.variance[plane].push_back(plane == kLuminance ? running.variance_y()
                                                           : running.variance()[plane]);
    }
  }
  return result;
}

Comparison compare(const Golden& golden, const Moments& round) {
  Comparison result{golden, {}, {}, {}, {}};
  const double samples = static_cast<double>(round.batches) * round.samples;
  for (int plane = 0; plane < kPlanes; ++plane) {
    for (std::size_t i = 0; i < golden.samples.size(); ++i) {
      const double variance = golden.variance[plane][i];
      result.difference[plane].push_back(round.mean[plane][i] - golden.mean[plane][i]);
      result.own[plane].push_back(round.variance[plane][i] / round.batches);
      result.expected[plane].push_back(variance / samples);
      result.golden_error[plane].push_back(variance / golden.samples[i]);
    }
  }
  return result;
}

}  // namespace grader::pictures
