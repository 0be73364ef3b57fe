#include "measure/charts/gnuplot.h"
#include "pt/file.h"
#include "writeup/compose.h"
#include "writeup/figure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include <fmt/format.h>

// Draws a table and a chart of what rules for the samples of a pixel can win, by the noise of a uniform picture.
// All have as many samples in the whole picture as the rule of adaptive_pixel's contract.

namespace writeup {

namespace {

// A rule gives a pixel its weight, times a factor that is the same in all of them.
struct Rule {
  const char *id, *title, *short_title, *color;
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

// Parts of all pixels, in per cent.
constexpr double kNoisier[] = {50, 20, 10, 5, 2, 1, .5, .2, .1, .05, .02, .01};

// The line of a rule in the chart: the noise in per cent that each of these parts exceeds.
struct Line {
  std::string name, title, color;
  std::vector<double> noise;
};

std::vector<double> exceeded(std::vector<double> squares) {
  std::ranges::sort(squares, std::greater<>());
  std::vector<double> noise;
  for (const double part : kNoisier) {
    const auto place = static_cast<std::size_t>(part / 100 * static_cast<double>(squares.size()));
    noise.push_back(100 * std::sqrt(squares.at(place)));
  }
  return noise;
}

void draw_lines(const std::vector<Line>& lines, const std::filesystem::path& folder,
                const std::string& name, const std::string& subject) {
  std::string csv = "noisier", plot, values;
  for (const Line& line : lines) csv += ',' + line.name;
  csv += '\n';
  for (std::size_t row = 0; row < std::size(kNoisier); ++row) {
    csv += fmt::format("{}", kNoisier[row]);
    for (const Line& line : lines) csv += fmt::format(",{:.5g}", line.noise[row]);
    csv += '\n';
  }
  pt::write_file(folder / (name + ".csv"), csv);
  double low = HUGE_VAL, high = 0;
  std::vector<measure::NamedEnd> ends;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto [least, most] = std::ranges::minmax(lines[i].noise);
    low = std::min(low, least);
    high = std::max(high, most);
    ends.push_back({lines[i].title, lines[i].color, lines[i].noise.back()});
    const std::string data = fmt::format("\"{}.csv\" skip 1", name);
    const std::string height = fmt::format("${}", i + 2);
    plot += fmt::format("{} {} using 1:{} with lines lw 2 lc rgb \"{}\"", i == 0 ? "plot" : ",",
                        data, i + 2, lines[i].color);
    values += measure::under_the_pointer({data, lines[i].title, "$1", height, height, ""});
  }
  measure::draw(folder, name,
                "set title \"" + subject +
                    "\" noenhanced\nset logscale xy\nset xrange [50:.01]\nset xlabel \"pixels with "
                    "more noise, %\"\n"
                    "set ylabel \"noise, %\"\nset ytics add (2, 5, 20, 50)\n" +
                    measure::names_beside(ends, std::max(low, high / 1e4) / 1.2, high * 1.2) +
                    plot + values + '\n',
                "The noise of single pixels that a part of all pixels exceeds, by rules for "
                "adaptive sampling that take as many samples: " +
                    subject + ".");
}

Line enter(const Rule& rule, const std::vector<double>& samples, const std::vector<Pixel>& pixels,
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
  const pt::PixelErrors noise = pt::pixel_errors(squares);
  const auto number = [&](const char* name, double value) {
    return drawn.numbers[fmt::format("{}.{}", rule.id, name)] = digits(value);
  };
  drawn.rows.push_back(
      {rule.title, number("error", error) + " %", number("median", 100 * noise.median) + " %",
       number("most", 100 * noise.most) + " %", number("largest", 100 * noise.largest) + " %",
       number("on_black", 100 * on_black / all) + " %"});
  return {rule.id, rule.short_title, rule.color, exceeded(std::move(squares))};
}

}  // namespace

Drawn draw_rules(const Plan& plan, const Figure& figure, const std::filesystem::path& folder) {
  Drawn drawn;
  const Picture& picture = figure.pictures.at(0);
  const Rendered uniform = plan.store().load(plan.uniform(picture));
  const std::optional<pt::Goldens> goldens = goldens_of(plan, figure);
  const pt::AdaptiveSettings settings = plan.adaptive(picture);
  if (!uniform.has_variance || !goldens) {
    drawn.problems.emplace_back("the uniform picture or its goldens are not there");
    return drawn;
  }
  std::vector<Pixel> pixels;
  for (std::size_t i = 0; i < uniform.film.pixels.size(); ++i) {
    pixels.push_back({uniform.film.pixels[i].variance_y, goldens->mean(i), goldens->scale(i)});
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
  using namespace measure::ink;
  const Rule contract{"contract", "the contract's", "contract", kBlue, {}};
  std::vector<Line> lines{enter(contract, of_contract, pixels, drawn)};
  for (const Rule& rule :
       {Rule{"uniform", "the same number everywhere", "uniform", kBlack,
             std::vector<double>(pixels.size(), 1)},
        Rule{"no_black", "the contract's, one batch on black", "one batch on black", kSky, squares},
        Rule{"root", "in proportion to \u03c3 / g", "\u03c3 / g", kPink, weights(pixels, 1)},
        Rule{"neighbours", "the most that a pixel or a neighbour needs", "neighbours", kGray,
             beside(squares, uniform.film.width)}}) {
    lines.push_back(enter(rule, samples_of(rule.weights, average, settings), pixels, drawn));
  }
  const measure::Spec spec = plan.uniform(picture).spec;
  draw_lines(lines, folder, figure.id + "_noise",
             fmt::format("{}, {} x {} pixels, l = {}, m = {}, {} samples in the mean",
                         plan.scenes().short_name(picture.scene), spec.width, spec.height,
                         spec.path.light_samples, spec.path.to, drawn.numbers["samples"]));
  drawn.tables = {figure.id + "_noise.csv"};
  if (std::filesystem::exists(folder / (figure.id + "_noise.svg"))) {
    drawn.charts = {figure.id + "_noise.svg"};
  }
  return drawn;
}

}  // namespace writeup
