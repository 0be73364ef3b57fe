#include "bench/cycles_report.h"

#include "measure/charts/gnuplot.h"
#include "pt/file.h"
#include "pt/image/image_io.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pt {
namespace {

// Our mean luminance in one region, and theirs.
struct Agreement {
  Uncertain ours, theirs;
  double relative = 0;        // theirs / ours - 1
  double relative_error = 0;  // its standard error
  double sigmas = 0;  // the difference in units of its standard error; 0 where both are exact
};

Agreement agreement(const Uncertain& ours, const Uncertain& theirs) {
  Agreement result{ours, theirs};
  const double error = std::hypot(ours.error, theirs.error);
  if (ours.value > 0) {
    result.relative = theirs.value / ours.value - 1;
    result.relative_error = error / ours.value;
  }
  // Pixels that show a light are the same in each render, except for rounding.
  if (error > 1e-6 * ours.value) result.sigmas = (theirs.value - ours.value) / error;
  return result;
}

Agreement agreement(const SceneReport& report, std::size_t region) {
  const std::vector<LongRender>& goldens = report.comparison.goldens;
  return agreement(goldens[0].regions[region], goldens[1].regions[region]);
}

std::string region_table(const SceneReport& report) {
  std::string text = fmt::format("  {:<32}{:>7}{:>22}{:>22}{:>20}{:>8}\n", "region", "pixels",
                                 "ours", "Cycles", "difference", "sigmas");
  for (std::size_t i = 0; i < report.regions.size(); ++i) {
    const Agreement a = agreement(report, i);
    const auto mean = [](const Uncertain& m) {
      return fmt::format("{:.6f} \u00b1 {:.6f}", m.value, m.error);
    };
    text += fmt::format(
        "  {:<32}{:>7}{:>22}{:>22}{:>20}{:>8.1f}\n", report.regions[i].name,
        report.regions[i].pixels.size(), mean(a.ours), mean(a.theirs),
        fmt::format("{:+.3f} \u00b1 {:.3f} %", 100 * a.relative, 100 * a.relative_error), a.sigmas);
  }
  return text;
}

// Compares both with a formula that has no noise.
std::string formula_table(const SceneReport& report) {
  if (!report.by_formula) return "";
  std::string text = fmt::format("\n  {:<32}{:>12}{:>22}{:>8}{:>22}{:>8}\n", "region", "by formula",
                                 "ours", "sigmas", "Cycles", "sigmas");
  for (std::size_t i = 0; i < report.regions.size(); ++i) {
    const Uncertain exact{(*report.by_formula)[i], 0};
    text += fmt::format("  {:<32}{:>12.6f}", report.regions[i].name, exact.value);
    for (const LongRender& golden : report.comparison.goldens) {
      const Agreement a = agreement(exact, golden.regions[i]);
      text += fmt::format(
          "{:>22}{:>8.1f}",
          fmt::format("{:+.3f} \u00b1 {:.3f} %", 100 * a.relative, 100 * a.relative_error),
          a.sigmas);
    }
    text += "\n";
  }
  return text;
}

// The mean of error^2 x seconds. The ratio of two costs is the ratio of the times for the same error.
double cost(const ErrorCurve& curve) {
  double sum = 0;
  for (const ErrorAfter& point : curve.points) {
    sum += point.errors[0].value * point.errors[0].value * point.cpu_seconds;
  }
  return sum / static_cast<double>(curve.points.size());
}

std::string error_table(const SceneReport& report) {
  std::string text = fmt::format("  {:<28}{:>6}{:>10}{:>20}{:>22}\n", "renderer", "s", "seconds",
                                 "error", "by the other golden");
  const auto percent = [](const Uncertain& m) {
    return fmt::format("{:.2f} \u00b1 {:.2f} %", 100 * m.value, 100 * m.error);
  };
  for (std::size_t i = 0; i < report.titles.size(); ++i) {
    const ErrorCurve& curve = report.comparison.curves[i];
    for (const ErrorAfter& point : curve.points) {
      text += fmt::format("  {:<28}{:>6}{:>10.3f}{:>20}{:>22}\n", report.titles[i], point.samples,
                          point.cpu_seconds, percent(point.errors[0]), percent(point.errors[1]));
    }
    text += fmt::format(
        "  {:<28}the same error takes {:.2f} of the time of the first; {:.3f} s per render besides "
        "its samples\n",
        "", cost(curve) / cost(report.comparison.curves[0]), curve.fixed_seconds);
  }
  return text;
}

const char* const kChart = R"gp(set logscale xy
set xlabel "processor seconds for the picture"
set ylabel "error (root of relMSE)"
set key top right
plot )gp";

// Our curves are blue, theirs are vermilion; each has dashes of its own.
void draw_errors(const SceneReport& report, const std::filesystem::path& folder) {
  const std::string file = report.scene + "_error.csv";
  std::string csv = "renderer,samples,seconds,error,error_of_it\n", plot = kChart;
  int used[2] = {0, 0};
  for (std::size_t i = 0; i < report.titles.size(); ++i) {
    const std::string& title = report.titles[i];
    const bool ours = title.starts_with("ours");
    if (i > 0) csv += "\n\n";
    for (const ErrorAfter& point : report.comparison.curves[i].points) {
      csv += fmt::format("\"{}\",{},{:.6g},{:.6g},{:.3g}\n", title, point.samples,
                         point.cpu_seconds, point.errors[0].value, point.errors[0].error);
    }
    plot += fmt::format(
        "{}\"{}\" index {} using 3:4:5 with yerrorlines lc rgb \"{}\" dt {} lw 1.5 pt {} ps .6 "
        "title \"{}\"",
        i > 0 ? ", " : "", file, i, ours ? measure::ink::kBlue : measure::ink::kVermilion,
        ++used[ours], ours ? 7 : 5, title);
  }
  write_file(folder / file, csv);
  measure::draw(folder, report.scene, plot + "\n");
}

// Writes the pictures of the long renders, so that ./run compare can compare them.
void write_pictures(const SceneReport& report, const std::filesystem::path& folder) {
  const char* const names[] = {"ours", "cycles"};
  for (int i = 0; i < 2; ++i) {
    const Image& image = report.comparison.goldens[i].picture;
    Film film(image.width, image.height);
    for (std::size_t j = 0; j < image.pixels.size(); ++j) film.pixels[j].mean = image.pixels[j];
    write_exr(folder / fmt::format("{}_{}.exr", report.scene, names[i]), film);
  }
}

}  // namespace

std::string to_text(const SceneReport& report) {
  std::string text = report.scene + "\n" + region_table(report) + formula_table(report) + "\n" +
                     error_table(report) + "\n";
  for (const StartTimes& start : report.times) {
    text += fmt::format("  {}: {:.2f} s until the scene is loaded, {:.3f} s for the tree\n",
                        start.title, start.scene, start.tree);
  }
  return text;
}

void write_reports(const std::vector<SceneReport>& reports, const std::filesystem::path& folder) {
  std::string csv = "scene,region,pixels,ours,ours_error,cycles,cycles_error,sigmas,by_formula\n";
  for (const SceneReport& report : reports) {
    for (std::size_t i = 0; i < report.regions.size(); ++i) {
      const Agreement a = agreement(report, i);
      csv += fmt::format("{},\"{}\",{},{:.8g},{:.3g},{:.8g},{:.3g},{:.2f},{}\n", report.scene,
                         report.regions[i].name, report.regions[i].pixels.size(), a.ours.value,
                         a.ours.error, a.theirs.value, a.theirs.error, a.sigmas,
                         report.by_formula ? fmt::format("{:.8g}", (*report.by_formula)[i]) : "");
    }
    draw_errors(report, folder);
    write_pictures(report, folder);
  }
  write_file(folder / "regions.csv", csv);
}

}  // namespace pt
