#include "measure/charts/gnuplot.h"
#include "measure/scene/print.h"
#include "pt/file.h"

#include <cmath>

#include <fmt/format.h>

namespace measure::scene {

namespace fs = std::filesystem;

namespace {

const char* const kOptionsChart = R"gp(set logscale xy
set ylabel "error (root of relMSE)"
plot )gp";

const char* const kBouncesChart = R"gp(set logscale y
set xlabel "most bounces, m"
set ylabel "missing: root of relMSE"
set format y "%g"
set key off
plot "bounces.csv" using 1:($2 > 0 ? $2 : NaN) skip 1 with linespoints lc rgb "#0072b2" lw 2 pt 7 ps .6{})gp";

const char* const kNoiseChart = R"gp(set logscale x 2
set yrange [0:*]
set y2range [0:*]
set y2tics
set ytics nomirror
set xlabel "light samples, l" offset 0,.5
set ylabel "relative variance of a camera sample"
set y2label "microseconds per camera sample"
set key below samplen 2
plot "noise.csv" using 1:2:3 skip 1 with yerrorbars lc rgb "#0072b2" pt 7 ps .6 title "variance", \
     {:.8g} + {:.8g} / x lc rgb "#0072b2" lw 2 title "A + B / l", \
     "" using 1:4:5 skip 1 axes x1y2 with yerrorbars lc rgb "#d55e00" pt 5 ps .6 title "time", \
     {:.8g} + {:.8g} * x axes x1y2 lc rgb "#d55e00" lw 2 title "c0 + c1 l"{}{} axes x1y2)gp";

// A line of the file, and of the chart if it has a colour: a way with its numbers of light samples.
struct ChartLine {
  std::string title;
  const Option* option;
  int light_samples;
  std::string color;
  int dashes;
};

std::vector<ChartLine> curves(const Answer& answer) {
  std::vector<ChartLine> all;
  const auto add = [&](const std::string& what, const Option& option, const char* ink,
                       int dashes = 1) {
    if (option.choice) all.push_back({what, &option, option.choice->light_samples, ink, dashes});
  };
  add("cheapest", answer.best, ink::kBlack);
  add("the course's settings", answer.course, ink::kSky);
  for (std::size_t i = 0; i < answer.survivals.size(); ++i) {
    const Option& option = answer.survivals[i];
    const bool is_last = i > 0 && i + 1 == answer.survivals.size();
    add(fmt::format("survival {:g}", option.way.survival), option,
        i == 1 || is_last ? ink::kGreen : "", is_last ? 2 : 1);
  }
  for (const Option& option : answer.bounces) {
    add(fmt::format("at most {} bounces", option.way.bounces), option,
        &option == &answer.bounces[0] ? ink::kBlack : "", 2);
  }
  add("hemisphere sampling", answer.hemisphere, ink::kVermilion);
  return all;
}

// The points of each line follow from what was measured with its light samples, and the bias.
void draw_options(const Answer& answer, const Options& asked) {
  const fs::path& folder = asked.out;
  const double pixels = static_cast<double>(asked.width) * asked.height;
  constexpr int kMostSamples = 1 << 14;
  std::string csv = "title,light_samples,samples,seconds,error\n", plot, points;
  std::vector<NamedEnd> ends;
  double low = answer.error, high = answer.error;
  int block = 0;
  for (const ChartLine& curve : curves(answer)) {
    const Choice& choice = *curve.option->choice;
    const auto error = [&](int s) {
      return std::sqrt(choice.variance / s + curve.option->model.bias2);
    };
    if (block > 0) csv += "\n\n";
    for (int s = kFewestSamples; s <= kMostSamples; s *= 2) {
      csv += fmt::format("{},{},{},{:.6g},{:.6g}\n", curve.title, curve.light_samples, s,
                         pixels * s * choice.seconds / choice.samples, error(s));
    }
    if (!curve.color.empty()) {
      plot += fmt::format(
          "\"options.csv\" index {} using 4:5 skip {} with lines lc rgb \"{}\" lw {} dt {}", block,
          block == 0 ? 1 : 0, curve.color, block < 2 ? 3 : 2, curve.dashes);
      plot += under_the_pointer(
                  {fmt::format("\"options.csv\" index {} skip {}", block, block == 0 ? 1 : 0),
                   curve.title, "$4", "$5", "$5", ""}) +
              ", ";
      ends.push_back({curve.title, curve.color, error(kMostSamples)});
      low = std::min(low, error(kMostSamples));
      high = std::max(high, error(kFewestSamples));
    }
    // The place of the cheapest, and of the course's settings, on its line. The course's may not reach
    // the error, and then has none.
    if (curve.option == &answer.best || curve.option == &answer.course) {
      points += fmt::format("set label at {:.6g},{:.6g} point pt 7 ps 1.2 lc rgb \"{}\" front\n",
                            choice.seconds * pixels, choice.error, curve.color);
    }
    ++block;
  }
  pt::write_file(folder / "options.csv", csv);
  plot += fmt::format("{:.6g} lc rgb \"{}\" dt 2\n", answer.error, ink::kGray);
  ends.push_back({"error wanted", ink::kGray, answer.error});
  const Way& way = answer.best.way;
  const std::string settings = fmt::format(
      "at most {} bounces and survival {:g} where nothing else is said", way.bounces, way.survival);
  draw(
      folder, "options",
      title_of(asked, settings) + "set xlabel \"" + processor_seconds() + "\"\n" + points +
          names_beside(std::move(ends), low / 1.3, high * 1.3) + kOptionsChart + plot,
      caption_of(asked, "Error over processor seconds, setting by setting", settings, processor()));
}

void draw_bounces(const Answer& answer, const Options& options) {
  const fs::path& folder = options.out;
  const std::string settings = "all light, with l = 1 and survival .7";
  std::string csv = "most_bounces,bias\n";
  for (std::size_t m = 0; m < answer.bias2.size(); ++m) {
    csv += fmt::format("{},{:.6g}\n", m, std::sqrt(answer.bias2[m].value));
  }
  pt::write_file(folder / "bounces.csv", csv);
  draw(
      folder, "bounces",
      title_of(options, settings) +
          fmt::format(fmt::runtime(kBouncesChart),
                      under_the_pointer({"\"bounces.csv\" skip 1", "missing with at most m bounces",
                                         "$1", "($2 > 0 ? $2 : NaN)", "$2", ""})),
      caption_of(options, "The error that m bounces leave, with any number of samples", settings,
                 ""));
}

void draw_noise(const Answer& answer, const Options& options) {
  const fs::path& folder = options.out;
  const Option& option = answer.survivals[0];
  const std::string settings =
      fmt::format("at most {} bounces, survival {:g}", option.way.bounces, option.way.survival);
  std::string csv = "light_samples,variance,variance_error,microseconds,microseconds_error,rays\n";
  for (const Tried& tried : option.tried) {
    csv += fmt::format("{},{:.6g},{:.3g},{:.6g},{:.3g},{:.6g}\n", tried.light_samples,
                       tried.variance.value, tried.variance.error, 1e6 * tried.seconds.value,
                       1e6 * tried.seconds.error, tried.rays);
  }
  pt::write_file(folder / "noise.csv", csv);
  draw(folder, "noise",
       title_of(options, settings + (processor().empty() ? "" : "; " + processor())) +
           fmt::format(
               fmt::runtime(kNoiseChart), option.model.noise.at_zero, option.model.noise.slope,
               1e6 * option.model.seconds.at_zero, 1e6 * option.model.seconds.slope,
               under_the_pointer({"\"noise.csv\" skip 1", "variance", "$1", "$2", "$2", "$3"}),
               under_the_pointer({"\"noise.csv\" skip 1", "microseconds", "$1", "$4", "$4", "$5"})),
       caption_of(options, "Variance and time of a camera sample by its light samples", settings,
                  processor()));
}

}  // namespace

void write_charts(const Answer& answer, const Options& options, const pt::Scene& scene) {
  const fs::path& folder = options.out;
  const double pixels = static_cast<double>(options.width) * options.height;
  draw_options(answer, options);
  draw_bounces(answer, options);
  draw_noise(answer, options);
  pt::write_file(folder / "cheapest.json", to_json(answer, scene.primitives.size(), pixels).dump());
}

}  // namespace measure::scene
