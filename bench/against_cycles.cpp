#include "bench/against_cycles.h"

#include "bench/report.h"
#include "pt/image/compare.h"
#include "pt/math/uncertain.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pt {
namespace {

std::vector<double> luminances(const Image& image) {
  std::vector<double> values;
  values.reserve(image.pixels.size());
  for (const Rgb& pixel : image.pixels) values.push_back(luminance(pixel));
  return values;
}

// The sum of the renders of a golden so far.
struct LongRenderSum {
  Image picture;
  std::vector<double> halves[2];
  std::vector<std::vector<double>> means;  // [region][render]

  explicit LongRenderSum(std::size_t regions) : means(regions) {}

  void add(const Image& image, int half, const std::vector<Region>& regions) {
    const std::vector<double> values = luminances(image);
    if (picture.pixels.empty()) picture = Image(image.width, image.height);
    halves[half].resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      halves[half][i] += values[i];
      picture.pixels[i] += image.pixels[i];
    }
    for (std::size_t i = 0; i < regions.size(); ++i) {
      means[i].push_back(mean_over(regions[i], image));
    }
  }

  LongRender golden(int renders) const {
    LongRender golden{picture, {}, {}};
    for (Rgb& pixel : golden.picture.pixels) pixel /= renders;
    for (int i = 0; i < 2; ++i) {
      golden.halves[i] = halves[i];
      for (double& value : golden.halves[i]) value /= 0.5 * renders;
    }
    for (const std::vector<double>& region : means) golden.regions.push_back(mean_of(region));
    return golden;
  }
};

// relMSE without the noise of the golden, whose halves are independent of the picture and of each other.
double squared_error(const std::vector<double>& picture, const LongRender& golden) {
  double sum = 0, mean = 0;
  for (const Rgb& pixel : golden.picture.pixels) mean += luminance(pixel);
  const double dark = dark_of(mean / static_cast<double>(picture.size()));
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const double g0 = golden.halves[0][i], g1 = golden.halves[1][i];
    const double scale = 0.5 * (g0 + g1) + dark;
    sum += (picture[i] - g0) * (picture[i] - g1) / (scale * scale);
  }
  return sum / static_cast<double>(picture.size());
}

// The square root of the mean of `squares`. It is unknown if the mean is not positive.
Uncertain root_of(const std::vector<double>& squares) {
  const Uncertain square = mean_of(squares);
  if (!(square.value > 0)) return {0, std::sqrt(square.error)};
  const double root = std::sqrt(square.value);
  return {root, 0.5 * square.error / root};
}

// All renders with the same number of samples.
struct Repeats {
  std::vector<double> seconds;
  std::vector<std::vector<double>> squares;  // relMSE, by golden
};

// Makes the renders of a comparison and reports their progress.
class Renders {
 public:
  Renders(const std::vector<Contender>& contenders, const std::vector<Region>& regions,
          const Effort& effort, const std::function<void(double)>& progress)
      : contenders_(contenders),
        regions_(regions),
        effort_(effort),
        progress_(progress),
        seed_(effort.seed) {}

  std::vector<LongRender> goldens(const std::vector<int>& of);
  // Indexed by contender and number of samples. The first renders have one sample: they show the fixed time.
  std::vector<std::vector<Repeats>> repeats(const std::vector<LongRender>& goldens,
                                            const std::vector<int>& samples);
  void count_renders(std::size_t goldens, int samples_of_repeats) {
    all_ = static_cast<double>(goldens) * effort_.golden_renders * effort_.golden_samples +
           static_cast<double>(contenders_.size()) * effort_.repeats * samples_of_repeats;
  }

 private:
  TimedImage render(std::size_t contender, int samples) {
    TimedImage timed = contenders_[contender].render(samples, seed_++);
    done_ += samples;
    progress_(done_ / all_);
    return timed;
  }

  const std::vector<Contender>& contenders_;
  const std::vector<Region>& regions_;
  const Effort& effort_;
  const std::function<void(double)>& progress_;
  double done_ = 0, all_ = 1;  // samples per pixel
  std::uint32_t seed_;         // for the next render
};

std::vector<LongRender> Renders::goldens(const std::vector<int>& of) {
  std::vector<LongRenderSum> sums(of.size(), LongRenderSum(regions_.size()));
  for (int i = 0; i < effort_.golden_renders; ++i) {
    for (std::size_t j = 0; j < of.size(); ++j) {
      sums[j].add(render(of[j], effort_.golden_samples).image, i % 2, regions_);
    }
  }
  std::vector<LongRender> goldens;
  goldens.reserve(sums.size());
  for (const LongRenderSum& sum : sums) goldens.push_back(sum.golden(effort_.golden_renders));
  return goldens;
}

std::vector<std::vector<Repeats>> Renders::repeats(const std::vector<LongRender>& goldens,
                                                   const std::vector<int>& samples) {
  const Repeats empty{{}, std::vector<std::vector<double>>(goldens.size())};
  std::vector<std::vector<Repeats>> all(contenders_.size(),
                                        std::vector<Repeats>(samples.size(), empty));
  for (int i = 0; i < effort_.repeats; ++i) {
    for (std::size_t k = 0; k < samples.size(); ++k) {
      for (std::size_t j = 0; j < contenders_.size(); ++j) {
        const TimedImage timed = render(j, samples[k]);
        Repeats& repeats = all[j][k];
        repeats.seconds.push_back(timed.cpu_seconds);
        const std::vector<double> picture = luminances(timed.image);
        for (std::size_t g = 0; g < goldens.size(); ++g) {
          repeats.squares[g].push_back(squared_error(picture, goldens[g]));
        }
      }
    }
  }
  return all;
}

// A render of s samples takes a + b s seconds. The line through the shortest and the longest render gives a.
ErrorCurve curve_of(const std::vector<Repeats>& all, const std::vector<int>& samples) {
  const double shortest = median_of(all.front().seconds), longest = median_of(all.back().seconds);
  const double slope = (longest - shortest) / (samples.back() - samples.front());
  ErrorCurve curve;
  curve.fixed_seconds = std::max(shortest - slope * samples.front(), 0.0);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    ErrorAfter point{samples[k], median_of(all[k].seconds) - curve.fixed_seconds, {}};
    for (const std::vector<double>& squares : all[k].squares) {
      point.errors.push_back(root_of(squares));
    }
    curve.points.push_back(point);
  }
  return curve;
}

}  // namespace

RendererComparison compare(const std::vector<Contender>& contenders,
                           const std::vector<int>& golden_of, const std::vector<Region>& regions,
                           const Effort& effort, const std::function<void(double)>& progress) {
  std::vector<int> samples{1};
  samples.insert(samples.end(), effort.samples.begin(), effort.samples.end());
  Renders renders(contenders, regions, effort, progress);
  renders.count_renders(golden_of.size(), std::accumulate(samples.begin(), samples.end(), 0));
  RendererComparison result;
  result.goldens = renders.goldens(golden_of);
  for (const std::vector<Repeats>& all : renders.repeats(result.goldens, samples)) {
    result.curves.push_back(curve_of(all, samples));
  }
  return result;
}

}  // namespace pt
