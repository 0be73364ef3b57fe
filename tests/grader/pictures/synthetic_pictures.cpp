#include "tests/grader/pictures/synthetic_pictures.h"

#include <algorithm>
#include <cmath>

namespace grader::pictures {
namespace {

constexpr double kFirefly = 1e-3;
constexpr double kFireflySize = 30;  // the mean; lognormal, sigma 1
constexpr double kFireflyMean = kFirefly * kFireflySize;

// The key light's shadow: 1 % of the picture.
bool in_shadow(const SyntheticScene& scene, int x, int y) {
  const double u = (x + 0.5) / scene.width, v = (y + 0.5) / scene.height;
  return u > 0.6 && u < 0.7 && v > 0.5 && v < 0.6;
}

double wave(double x) { return 0.5 + 0.5 * std::sin(x); }

SyntheticPixel floor_pixel(Spread spread, double u, double v) {
  SyntheticPixel pixel;
  const double light = 0.3 + 0.9 * std::exp(-4 * ((u - 0.4) * (u - 0.4) + (v - 0.6) * (v - 0.6)));
  pixel.direct = light * pt::Rgb{0.8, 0.7 + 0.1 * wave(9 * u), 0.55};
  pixel.indirect = 0.35 * pt::Rgb{0.5 + 0.4 * u, 0.5, 0.5 + 0.4 * (1 - u)};
  const double deviation = 0.3 * std::pow(10, wave(7 * u + 5 * v));
  pixel.shape = 1 / (deviation * deviation);
  if (spread == Spread::mostly_zero) {
    pixel.shape = 2;
    pixel.hit = 0.5 * std::pow(50, -wave(5 * u - 6 * v));
  }
  return pixel;
}

}  // namespace

SyntheticScene synthetic_scene(Spread spread, int width, int height) {
  SyntheticScene scene{width, height, spread, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width, v = (y + 0.5) / height;
      SyntheticPixel pixel = floor_pixel(spread, u, v);
      if (v < 0.12) {
        pixel = {{}, {}, 1, 1, true};
        if (u > 0.4 && u < 0.6) pixel.direct = {5, 5, 4};
      } else if (in_shadow(scene, x, y)) {
        pixel.direct *= 0.4;
      }
      scene.pixels.push_back(pixel);
    }
  }
  return scene;
}

// The mean of `count` gamma numbers of this shape and mean 1 (Marsaglia and Tsang 2000). A sum of
// gamma numbers is a gamma number.
double Draw::gamma(double shape, double count) {
  const double k = shape * count;
  if (k < 1) return std::gamma_distribution<double>(k, 1 / k)(random_);
  const double d = k - 1.0 / 3, c = 1 / std::sqrt(9 * d);
  while (true) {
    const double x = normal_(random_), cube = 1 + c * x;
    if (cube <= 0) continue;
    const double v = cube * cube * cube;
    const double u = std::generate_canonical<double, 53>(random_);
    if (std::log(u) < 0.5 * x * x + d - d * v + d * std::log(v)) return d * v / k;
  }
}

// Draws a binomial number from the gaps between hits, which is fast if hits are rare.
int Draw::hits(int samples, double probability) {
  if (probability >= 1) return samples;
  const double scale = 1 / std::log1p(-probability);
  double at = 0;
  for (int count = 0;; ++count) {
    at += 1 + std::floor(std::log(1 - std::generate_canonical<double, 53>(random_)) * scale);
    if (at > samples) return count;
  }
}

Draw::Sums Draw::indirect(const SyntheticPixel& pixel, Spread spread, int samples) {
  const bool also_zero = spread == Spread::mostly_zero;
  return light(pixel, also_zero ? spread : Spread::diffuse, samples);
}

// The squares have the value that numbers with this mean have on average.
Draw::Sums Draw::lit(const SyntheticPixel& pixel, int count) {
  const double mean = gamma(pixel.shape, count);
  return {mean * count, count * mean * mean + (count - 1) / pixel.shape};
}

Draw::Sums Draw::light(const SyntheticPixel& pixel, Spread spread, int samples) {
  if (spread == Spread::mostly_zero) {
    const int count = hits(samples, pixel.hit);
    if (count == 0) return {};
    const Sums sums = lit(pixel, count);
    return {sums.x / pixel.hit, sums.xx / (pixel.hit * pixel.hit)};
  }
  Sums sums = lit(pixel, samples);
  if (spread == Spread::fireflies) {
    for (int i = hits(samples, kFirefly); i > 0; --i) {
      const double size = kFireflySize * std::exp(normal_(random_) - 0.5);
      sums.x += size;
      sums.xx += size * size + 2 * size;
    }
    const double scale = 1 / (1 + kFireflyMean);
    sums = {sums.x * scale, sums.xx * scale * scale};
  }
  return sums;
}

Draw::Moments Draw::moments(const Sums& sums, int samples) {
  const double mean = sums.x / samples;
  return {mean, std::max(0.0, sums.xx - samples * mean * mean) / (samples - 1)};
}

pt::Image Draw::image(const SyntheticScene& scene, int samples) {
  pt::Image image(scene.width, scene.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const SyntheticPixel& pixel = scene.pixels[i];
    if (pixel.constant) {
      image.pixels[i] = pixel.direct;
    } else {
      image.pixels[i] = pixel.direct * (light(pixel, scene.spread, samples).x / samples) +
                        pixel.indirect * (indirect(pixel, scene.spread, samples).x / samples);
    }
  }
  return image;
}

Batches Draw::batches(const SyntheticScene& scene, int batches, int samples) {
  Batches result{samples, {}};
  for (int b = 0; b < batches; ++b) result.images.push_back(image(scene, samples));
  return result;
}

pt::Film Draw::golden(const SyntheticScene& scene, int samples) {
  pt::Film film(scene.width, scene.height);
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    const SyntheticPixel& pixel = scene.pixels[i];
    pt::FilmPixel& out = film.pixels[i];
    out.samples = samples;
    out.mean = pixel.direct;
    if (pixel.constant) continue;
    const Moments x = moments(light(pixel, scene.spread, samples), samples);
    const Moments y = moments(indirect(pixel, scene.spread, samples), samples);
    out.mean = pixel.direct * x.mean + pixel.indirect * y.mean;
    const auto of = [&](double a, double b) { return a * a * x.variance + b * b * y.variance; };
    for (int c = 0; c < 3; ++c) out.variance[c] = of(pixel.direct[c], pixel.indirect[c]);
    out.variance_y = of(luminance(pixel.direct), luminance(pixel.indirect));
  }
  return film;
}

RenderRound submission(const SyntheticScene& scene, std::uint64_t seed) {
  return [scene, seed](int round, int batches, int samples) {
    return Draw(seed * 4 + static_cast<std::uint64_t>(round)).batches(scene, batches, samples);
  };
}

std::vector<SyntheticError> synthetic_errors() {
  const auto each = [](auto change) {
    return [change](SyntheticScene& scene) {
      for (SyntheticPixel& pixel : scene.pixels) {
        if (!pixel.constant) change(pixel);
      }
    };
  };
  return {{"1 % too bright", each([](SyntheticPixel& p) {
             p.direct *= 1.01;
             p.indirect *= 1.01;
           })},
          {"10 % too dark in a 2 % block",
           [](SyntheticScene& scene) {
             for (int y = scene.height / 3; y < scene.height / 3 + scene.height / 6; ++y) {
               for (int x = scene.width / 4; x < scene.width / 4 + scene.width / 8; ++x) {
                 SyntheticPixel& pixel =
                     scene.pixels[static_cast<std::size_t>(y) * scene.width + x];
                 pixel.direct *= 0.9;
                 pixel.indirect *= 0.9;
               }
             }
           }},
          {"a shadow missing on 1 %",
           [](SyntheticScene& scene) {
             for (int y = 0; y < scene.height; ++y) {
               for (int x = 0; x < scene.width; ++x) {
                 if (!in_shadow(scene, x, y)) continue;
                 scene.pixels[static_cast<std::size_t>(y) * scene.width + x].direct *= 1 / 0.4;
               }
             }
           }},
          {"indirect light 5 % low", each([](SyntheticPixel& p) { p.indirect *= 0.95; })},
          {"one bounce too few", each([](SyntheticPixel& p) { p.indirect *= 0.8; })}};
}

SyntheticScene with(SyntheticScene scene, const SyntheticError& error) {
  error.make(scene);
  return scene;
}

}  // namespace grader::pictures
