#include "measure/charts/gnuplot.h"
#include "measure/scene/print.h"
#include "pt/file.h"

#include <cmath>

#include <fmt/format.h>

namespace measure::scene {

namespace fs = std::filesystem;

namespace {

const char* const kOptionsChart = R"gp(set logscale xy
set xlabel "processor seconds for the picture"
set ylabel "error (root of relMSE)"
set key outside right samplen 1.5 font ",11"
plot )gp";

const char* const kBouncesChart = R"gp(set logscale y
set xlabel "most bounces, m"
set ylabel "missing fraction of the radiance"
set format y "%g"
set key off
plot "bounces.csv" using 1:($2 > 0 ? $2 : NaN) skip 1 with linespoints lc rgb "#1b5288" lw 2 pt 7 ps .6
)gp";

const char* const kNoiseChart = R"gp(set logscale x 2
set yrange [0:*]
set y2range [0:*]
set y2tics
set ytics nomirror
set xlabel "light samples, l"
set ylabel "relative variance of a camera sample"
set y2label "microseconds per camera sample"
set key top center
plot "noise.csv" using 1:2:3 skip 1 with yerrorbars lc rgb "#1b5288" pt 7 ps .6 title "variance", \
     {:.8g} + {:.8g} / x lc rgb "#1b5288" lw 2 title "A + B / l", \
     "" using 1:4:5 skip 1 axes x1y2 with yerrorbars lc rgb "#a33708" pt 5 ps .6 title "time", \
     {:.8g} + {:.8g} * x axes x1y2 lc rgb "#a33708" lw 2 title "c0 + c1 l"
)gp";

// A line of the chart: a way with its numbers of light samples.
struct ChartLine {
  std::string title;
  const Option* option;
  int light_samples;
  std::string color;
};

std::vector<ChartLine> curves(const Answer& answer) {
  std::vector<ChartLine> all;
  const auto add = [&](const std::string& what, const Option& option, const char* ink) {
    if (option.choice) all.push_back({what, &option, option.choice->light_samples, ink});
  };
  add("cheapest", answer.best, "#000000");
  add("the course's settings", answer.course, "#e08214");
  int shade = 0;
  for (const Option& option : answer.survivals) {
    add(fmt::format("survival {:g}", option.way.survival), option, color(Hue::green, shade++));
  }
  for (const Option& option : answer.bounces) {
    add(fmt::format("at most {} bounces", option.way.bounces), option, color(Hue::blue, shade++));
  }
  add("hemisphere sampling", answer.hemisphere, color(Hue::red, 2));
  return all;
}

// The points of each line follow from what was measured with its light samples, and the bias.
void draw_options(const Answer& answer, double pixels, const fs::path& folder) {
  std::string csv = "title,light_samples,samples,seconds,error\n", plot;
  int block = 0;
  for (const ChartLine& curve : curves(answer)) {
    const Choice& choice = *curve.option->choice;
    if (block > 0) csv += "\n\n";
    for (int s = kFewestSamples; s <= 1 << 14; s *= 2) {
      csv += fmt::format("{},{},{},{:.6g},{:.6g}\n", curve.title, curve.light_samples, s,
                         pixels * s * choice.seconds / choice.samples,
                         std::sqrt(choice.variance / s + curve.option->model.bias2));
    }
    plot += fmt::format(
        "\"options.csv\" index {} using 4:5 with lines lc rgb \"{}\" lw {} title \"{}\", ", block,
        curve.color, block < 2 ? 3 : 1, curve.title);
    ++block;
  }
  pt::write_file(folder / "options.csv", csv);
  // The place of each of the two points on its line.
  std::string points;
  for (const auto& [option, ink] :
       {std::pair{&answer.best, "#000000"}, {&answer.course, "#e08214"}}) {
    if (!option->choice) continue;
    points += fmt::format("set label at {:.6g},{:.6g} point pt 7 ps 1.2 lc rgb \"{}\" front\n",
                          option->choice->seconds * pixels, option->choice->error, ink);
  }
  plot += fmt::format("{:.6g} lc rgb \"#8a9299\" dt 2 title \"error wanted\"\n", answer.error);
  draw(folder, "options", points + kOptionsChart + plot);
}

void draw_bounces(const Answer& answer, const fs::path& folder) {
  std::string csv = "most_bounces,bias\n";
  for (std::size_t m = 0; m < answer.bias2.size(); ++m) {
    csv += fmt::format("{},{:.6g}\n", m, std::sqrt(answer.bias2[m].value));
  }
  pt::write_file(folder / "bounces.csv", csv);
  draw(folder, "bounces", kBouncesChart);
}

void draw_noise(const Answer& answer, const fs::path& folder) {
  const Option& option = answer.survivals[0];
  std::string csv = "light_samples,variance,variance_error,microseconds,microseconds_error,rays\n";
  for (const Tried& tried : option.tried) {
    csv += fmt::format("{},{:.6g},{:.3g},{:.6g},{:.3g},{:.6g}\n", tried.light_samples,
                       tried.variance.value, tried.variance.error, 1e6 * tried.seconds.value,
                       1e6 * tried.seconds.error, tried.rays);
  }
  pt::write_file(folder / "noise.csv", csv);
  draw(folder, "noise",
       fmt::format(fmt::runtime(kNoiseChart), option.model.noise.at_zero, option.model.noise.slope,
                   1e6 * option.model.seconds.at_zero, 1e6 * option.model.seconds.slope));
}

}  // namespace

void write_charts(const Answer& answer, const Options& options, const pt::Scene& scene) {
  const fs::path& folder = options.out;
  const double pixels = static_cast<double>(options.width) * options.height;
  draw_options(answer, pixels, folder);
  draw_bounces(answer, folder);
  draw_noise(answer, folder);
  pt::write_file(folder / "cheapest.json", to_json(answer, scene.primitives.size(), pixels).dump());
}

}  // namespace measure::scene
