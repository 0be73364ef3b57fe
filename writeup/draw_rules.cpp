#include "pt/file.h"
#include "writeup/compose.h"
#include "writeup/figure.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// Draws a table of what rules for the samples of a pixel can win, by the noise of a uniform picture.
// All have as many samples in the whole picture as the rule of adaptive_pixel's contract.

namespace writeup {

namespace {

// A rule gives a pixel its weight, times a factor that is the same in all of them.
struct Rule {
  const char *id, *title;
  std::vector<double> weights;
};

struct Pixel {
  double variance = 0;  // of a sample's luminance
  double mean = 0;      // of the golden
  double scale = 0;     // the divisor of its error
};

std::vector<double> weights(const std::vector<Pixel>& pixels, double power) {
  std::vector<double> all;
  for (const Pixel& pixel : pixels) {
    all.push_back(
        pixel.mean > 0 ? std::pow(pixel.variance, power / 2) / std::pow(pixel.scale, power) : 0);
  }
  return all;
}

// The largest weight of each pixel and its eight neighbours.
std::vector<double> beside(const std::vector<double>& weights, int width) {
  const int height = static_cast<int>(weights.size()) / width;
  std::vector<double> all;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double most = 0;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
          most = std::max(most, weights[v * width + u]);
        }
      }
      all.push_back(most);
    }
  }
  return all;
}

// One batch at least, the maximum at most, and `average` on average.
std::vector<double> samples_of(const std::vector<double>& weights, double average,
                               const pt::AdaptiveSettings& settings) {
  double low = 0, high = 1;
  std::vector<double> all;
  const auto mean_with = [&](double factor) {
    all.clear();
    double sum = 0;
    for (const double weight : weights) {
      all.push_back(std::clamp<double>(factor * weight, settings.batch, settings.max_samples));
      sum += all.back();
    }
    return sum / static_cast<double>(weights.size());
  };
  constexpr double kMost = 1e30;
  while (high < kMost && mean_with(high) < average) high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (mean_with(middle) < average ? low : high) = middle;
  }
  mean_with(high);
  return all;
}

void enter(const Rule& rule, const std::vector<double>& samples, const std::vector<Pixel>& pixels,
           Drawn& drawn) {
  std::vector<double> squares;
  double sum = 0, all = 0, on_black = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    squares.push_back(pixels[i].variance / samples[i] / (pixels[i].scale * pixels[i].scale));
    sum += squares.back();
    all += samples[i];
    on_black += pixels[i].mean > 0 ? 0 : samples[i];
  }
  const double error = 100 * std::sqrt(sum / static_cast<double>(pixels.size()));
  const pt::PixelErrors noise = pt::pixel_errors(std::move(squares));
  const auto number = [&](const char* name, double value) {
    return drawn.numbers[fmt::format("{}.{}", rule.id, name)] = digits(value);
  };
  drawn.rows.push_back(
      {rule.title, number("error", error) + " %", number("median", 100 * noise.median) + " %",
       number("most", 100 * noise.most) + " %", number("largest", 100 * noise.largest) + " %",
       number("on_black", 100 * on_black / all) + " %"});
}

}  // namespace

Drawn draw_rules(const Plan& plan, const Figure& figure, const std::filesystem::path& folder) {
  Drawn drawn;
  const Picture& picture = figure.pictures.at(0);
  const Rendered uniform = plan.store().load(plan.uniform(picture));
  const Composed golden = compose(plan.store(), plan.units(figure, *figure.golden));
  const pt::AdaptiveSettings settings = plan.adaptive(picture);
  if (!uniform.has_variance || !golden.complete || !golden.sum.missing.empty()) {
    drawn.problems.emplace_back("the uniform picture or its golden is not there");
    return drawn;
  }
  const double dark = pt::dark_of(mean_luminance(golden.sum.film));
  std::vector<Pixel> pixels;
  for (std::size_t i = 0; i < uniform.film.pixels.size(); ++i) {
    const double mean = pt::luminance(golden.sum.film.pixels[i].mean);
    pixels.push_back({uniform.film.pixels[i].variance_y, mean, mean + dark});
  }
  const std::vector<int> counts = predicted_samples(uniform.film, settings);
  const std::vector<double> of_contract(counts.begin(), counts.end());
  double average = 0;
  for (const double count : of_contract) average += count / static_cast<double>(counts.size());
  drawn.numbers["samples"] = digits(average);
  drawn.columns = {"rule, with as many samples",
                   "error",
                   "noise of single pixels: median",
                   "99 % below",
                   "largest",
                   "samples on black pixels"};
  const std::vector<double> squares = weights(pixels, 2);
  const Rule contract{"contract", "the contract's", {}};
  enter(contract, of_contract, pixels, drawn);
  for (const Rule& rule :
       {Rule{"uniform", "the same number everywhere", std::vector<double>(pixels.size(), 1)},
        Rule{"no_black", "the contract's, one batch on black", squares},
        Rule{"root", "in proportion to \u03c3 / g", weights(pixels, 1)},
        Rule{"neighbours", "the most that a pixel or a neighbour needs",
             beside(squares, uniform.film.width)}}) {
    enter(rule, samples_of(rule.weights, average, settings), pixels, drawn);
  }
  std::string csv = "number,value\n";
  for (const auto& [name, value] : drawn.numbers) csv += name + ',' + value + '\n';
  drawn.tables = {figure.id + ".csv"};
  pt::write_file(folder / drawn.tables[0], csv);
  return drawn;
}

}  // namespace writeup
