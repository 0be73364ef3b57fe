// Compares rules by which a picture of random samples is judged: ours with a golden, that of Mitsuba 3 for the tests of its own
// renders, and Welch's test of two noisy pictures, by blocks as `./run compare A B` has it, and by pixel. To renders of the reference some
// light is added, everywhere or in a block. docs/verdicts.md has the figures.
#include "grader/pictures/recipes/recipes.h"
#include "grader/pictures/statistics/image_verdict.h"
#include "grader/pictures/statistics/welch.h"
#include "measure/charts/gnuplot.h"
#include "pt/command_line.h"
#include "pt/file.h"
#include "pt/render/render_film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

namespace fs = std::filesystem;
using namespace grader::pictures;

constexpr double kBiases[] = {0, .005, .01, .02, .03, .05, .07, .1, .15, .2, .3};
constexpr int kBlock = 5;  // the block has a fifth of the picture's width and height

// The samples that Mitsuba 3 renders in a test, in all pixels together (src/render/tests/test_renders.py, commit 042f6afb).
constexpr int kPeerBudget = 2'000'000;
constexpr const char *kOurs = "ours", *kPeer = "Mitsuba 3's", *kBlocks = "two pictures by blocks",
                     *kPixels = "two pictures by pixel";

// The rule of Mitsuba 3: a z-test of every channel of every pixel against the reference's mean and variance, at the level
// .01 with Sidak's correction for the number of pixels; 99.75 % of them have to pass. It takes X, Y and Z where we have
// red, green and blue.
bool peer_passes(const pt::Film& reference, const pt::Image& picture, int samples) {
  const auto pixels = static_cast<double>(picture.pixels.size());
  const double level = 1 - std::pow(1 - .01, 1 / pixels);
  double passed = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double variance = std::max(reference.pixels[i].variance[c], 1e-4);
      const double off = picture.pixels[i][c] - reference.pixels[i].mean[c];
      if (std::erfc(std::abs(off) * std::sqrt(samples / variance / 2)) > level) ++passed;
    }
  }
  return passed / 3 >= .9975 * pixels;
}

// Welch's test of the luminance of every pixel, at the level .01 with Sidak's correction: none may differ.
bool pixels_pass(const NoisyPicture& a, const NoisyPicture& b) {
  const double level = 1 - std::pow(1 - .01, 1 / static_cast<double>(a.variance.size()));
  for (std::size_t i = 0; i < a.variance.size(); ++i) {
    const double variance = a.variance[i] + b.variance[i];
    if (!(variance > 0)) continue;
    const double freedom =
        variance * variance /
        (a.variance[i] * a.variance[i] / a.freedom + b.variance[i] * b.variance[i] / b.freedom);
    const double off = luminance(a.mean.pixels[i]) - luminance(b.mean.pixels[i]);
    if (student_p(off / std::sqrt(variance), freedom) < level) return false;
  }
  return true;
}

struct Size {
  int width, height, pictures, golden;  // how many pictures are judged; the samples of their golden
};
const std::vector<Size> kSizes{{96, 72, 12, 4096}, {256, 256, 2, 512}};
const std::vector<Size> kQuickSizes{{48, 36, 1, 4096}};

// The picture with more light, everywhere or in a block in its middle.
pt::Image brighter(const pt::Image& image, bool everywhere, double bias) {
  pt::Image wrong = image;
  const int width = image.width / kBlock, height = image.height / kBlock;
  const int left = (image.width - width) / 2, top = (image.height - height) / 2;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const bool inside = x >= left && x < left + width && y >= top && y < top + height;
      if (everywhere || inside) wrong.at(x, y) = wrong.at(x, y) * (1 + bias);
    }
  }
  return wrong;
}

// A rule with the number of samples per pixel that it sees, and how many pictures it rejects, by bias.
struct Row {
  std::string rule;
  int samples = 0;
  bool everywhere = true;
  std::map<double, int> rejected{};
};

class Comparison {
 public:
  Comparison(Recipe recipe, Size size, int threads)
      : recipe_(std::move(recipe)),
        size_(size),
        threads_(threads),
        peer_samples_(kPeerBudget / (size.width * size.height)) {
    recipe_.width = size.width;
    recipe_.height = size.height;
    // A lamp that is seen straight has no noise, and no error of a path changes it.
    recipe_.settings.from = std::max(recipe_.settings.from, 1);
  }

  std::vector<Row> run();
  // The blocks of two equal pictures whose p lies in each tenth of 0 to 1.
  std::array<int, 10> p_of_equal_pictures{};

  std::string report(const std::vector<Row>& rows) const;

 private:
  // Each render has samples of its own.
  pt::Film render(const pt::View& view, int samples) {
    return render_film(view, {samples, {}, ++seed_, threads_}).film;
  }
  // Judges one right picture, and what each bias makes of it.
  void judge(const pt::View& view, const pt::Film& golden, std::vector<Row>& rows);

  Recipe recipe_;
  Size size_;
  int threads_, peer_samples_;
  std::uint64_t seed_ = 0;
};

void Comparison::judge(const pt::View& view, const pt::Film& golden, std::vector<Row>& rows) {
  const NoiseClass noise = recipe_.noisy ? NoiseClass::noisy : NoiseClass::ordinary;
  std::vector<Batches> rounds;
  for (const Round& round : rounds_of(noise)) {
    rounds.push_back({round.samples, {}});
    for (int i = 0; i < round.batches; ++i) {
      rounds.back().images.push_back(mean(render(view, round.samples)));
    }
  }
  const pt::Film one = render(view, peer_samples_), two = render(view, peer_samples_);
  const pt::Image peer = mean(one);
  const NoisyPicture a = noisy_picture(one, "a render"), b = noisy_picture(two, "a render");
  for (const BlockDifference& block : welch_test(a, b).blocks) {
    if (block.side == 8) {
      ++p_of_equal_pictures[std::min(static_cast<std::size_t>(10 * block.p), std::size_t{9})];
    }
  }
  for (Row& row : rows) {
    for (const double bias : kBiases) {
      const auto wrong = [&](const pt::Image& right) {
        return brighter(right, row.everywhere, bias);
      };
      bool passes = false;
      if (row.rule == kPeer) {
        passes = peer_passes(golden, wrong(peer), peer_samples_);
      } else if (row.rule == kBlocks || row.rule == kPixels) {
        NoisyPicture changed = a;
        changed.mean = wrong(a.mean);
        passes = row.rule == kBlocks ? welch_test(changed, b).differing.empty()
                                     : pixels_pass(changed, b);
      } else {
        const auto biased = [&](int round, int, int) {
          Batches batches = rounds[round - 1];
          for (pt::Image& image : batches.images) image = wrong(image);
          return batches;
        };
        passes = judge_image(golden, noise, biased, 3, recipe_.most_noise).outcome ==
                 ImageVerdict::Outcome::pass;
      }
      row.rejected[bias] += passes ? 0 : 1;
    }
  }
}

std::vector<Row> Comparison::run() {
  const RecipeScene scene = load_scene(recipe_, pt::Engine::wide);
  const pt::View picture = view(recipe_, scene);
  const auto done = [&](const std::string& what) {
    fmt::print(stderr, "{}, {} x {}: {}\n", recipe_.name, size_.width, size_.height, what);
  };
  const pt::Film golden = render(picture, size_.golden);
  done("the golden");
  const Round first = rounds_of(recipe_.noisy ? NoiseClass::noisy : NoiseClass::ordinary)[0];
  std::vector<Row> rows;
  for (const bool everywhere : {true, false}) {
    rows.push_back({kOurs, first.batches * first.samples, everywhere});
    for (const char* rule : {kPeer, kBlocks, kPixels}) {
      rows.push_back({rule, peer_samples_, everywhere});
    }
  }
  for (int i = 1; i <= size_.pictures; ++i) {
    judge(picture, golden, rows);
    done(fmt::format("{} of {}", i, size_.pictures));
  }
  return rows;
}

// Prints a table; returns it as CSV, with a block for each rule, as gnuplot's `index` counts them.
std::string Comparison::report(const std::vector<Row>& rows) const {
  fmt::print("\n{}, {} x {}: rejected of {}, by the light that was added\n{:<46}", recipe_.name,
             size_.width, size_.height, size_.pictures, "");
  for (const double bias : kBiases) fmt::print("{:>6.3g}%", 100 * bias);
  std::string csv;
  for (const Row& row : rows) {
    const char* where = row.everywhere ? "everywhere" : "in a block";
    fmt::print("\n{:<46}", fmt::format("{}, {} samples, {}", row.rule, row.samples, where));
    for (const auto& [bias, rejected] : row.rejected) {
      fmt::print("{:>7}", rejected);
      csv += fmt::format("{},{},{},{},{},{},{:g},{},{}\n", recipe_.name, size_.width, size_.height,
                         row.rule, row.samples, where, 100 * bias, rejected, size_.pictures);
    }
    csv += "\n\n";
  }
  fmt::print("\n");
  std::fflush(stdout);
  return csv;
}

const char* const kChart = R"gp(set logscale x
set xrange [.4:40]
set yrange [-3:103]
set xtics ("½" .5, 1, 2, 3, 5, 7, 10, 15, 20, 30)
set xlabel "light added to the whole picture, %"
set ylabel "pictures rejected, %"
set key outside below vertical maxrows 8 height 1
set terminal svg size 520,560 font "sans-serif,13"
plot )gp";

const char* const kHistogram = R"gp(set xrange [0:1]
set yrange [0:*]
set xlabel "p of a block of 8 × 8 pixels, two equal pictures"
set ylabel "blocks"
set style fill solid .5
plot "p.csv" using 1:2 with boxes lc rgb "%s" notitle, "p.csv" using 1:3 with lines lw 2 dt 2 lc rgb "%s" title "flat"
)gp";

const std::map<std::string, const char*> kInks{{kOurs, measure::ink::kBlue},
                                               {kPeer, measure::ink::kVermilion},
                                               {kBlocks, measure::ink::kGreen},
                                               {kPixels, measure::ink::kPink}};

// The rows of bias everywhere.
std::string curve(const Row& row, const Size& size, int index) {
  const bool large = size.width > kSizes[0].width;
  return fmt::format(
      "\"rules.csv\" index {} using ($7 > 0 ? $7 : NaN):(100 * $8 / $9) with linespoints lw 2 ps "
      ".6 "
      "pt {} dt {} lc rgb \"{}\" title \"{}, {} × {}, {} samples\"",
      index, large ? 6 : 7, large ? 2 : 1, kInks.at(row.rule), row.rule, size.width, size.height,
      row.samples);
}

struct Options {
  std::string recipe = "global_m2";
  bool quick = false;
  int threads = 2;
  fs::path out = FIRSTLIGHT_ROOT "/build/verdict_rules";
};

void write_histogram(const fs::path& out, const std::array<int, 10>& counts) {
  double all = 0;
  for (const int count : counts) all += count;
  std::string csv = "p,blocks,flat\n";
  for (std::size_t i = 0; i < counts.size(); ++i) {
    csv +=
        fmt::format("{:.2f},{},{:.1f}\n", 0.1 * static_cast<double>(i) + 0.05, counts[i], all / 10);
  }
  pt::write_file(out / "p.csv", csv);
  std::string chart = kHistogram;
  for (const char* ink : {measure::ink::kGreen, measure::ink::kVermilion}) {
    chart.replace(chart.find("%s"), 2, ink);
  }
  measure::draw(out, "p", chart);
}

int run(const Options& options) {
  const std::vector<Recipe> recipes = load_recipes(FIRSTLIGHT_ROOT "/scenes/recipes.json");
  const Recipe& recipe = find(recipes, options.recipe);
  fs::create_directories(options.out);
  std::string csv = "recipe,width,height,rule,samples,where,added_percent,rejected,pictures\n",
              curves;
  int index = 0;
  for (const Size& size : options.quick ? kQuickSizes : kSizes) {
    Comparison comparison(recipe, size, options.threads);
    const std::vector<Row> rows = comparison.run();
    csv += comparison.report(rows);
    if (index == 0) write_histogram(options.out, comparison.p_of_equal_pictures);
    for (const Row& row : rows) {
      if (row.everywhere) curves += (index > 0 ? ", " : "") + curve(row, size, index);
      ++index;
    }
  }
  pt::write_file(options.out / "rules.csv", csv);
  measure::draw(options.out, "rules", kChart + curves + "\n");
  fmt::print("\nwrote rules.csv, rules.svg, p.csv and p.svg to {}\n", options.out.string());
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app(
      "Compares our verdicts on pictures with the rule of Mitsuba 3's tests and with Welch's test\n"
      "by pixel: how many of the reference's pictures each rejects, right ones and ones with some\n"
      "light added. Writes rules.csv, p.csv, and a chart of each. Takes six minutes of processor\n"
      "time.",
      "./run bench verdicts");
  Options options;
  app.add_option("recipe", options.recipe, "of scenes/recipes.json")->capture_default_str();
  app.add_flag("--quick", options.quick, "one small picture: half a minute");
  app.add_option("-t,--threads", options.threads)
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--out", options.out, "folder for the files")->capture_default_str();
  return pt::run_command_line(app, count, arguments, [&] { return run(options); });
}
