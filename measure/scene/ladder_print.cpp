#include "measure/charts/gnuplot.h"
#include "measure/scene/ladder.h"
#include "pt/file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace measure::scene {

namespace {

std::string factor(const Uncertain& worth) {
  const int digits = worth.value < 10 ? 3 : worth.value < 1000 ? 1 : 0;
  return fmt::format("{:.{}f} \u00b1 {:.{}f}", worth.value, digits, worth.error, digits);
}

constexpr double kCounts = 2;  // standard errors from which an idea counts

// A remark on a rung whose error is uncertain, or is not noise alone.
std::string remark(const Climbed& rung, bool lowest) {
  if (rung.biased) return "  biased";
  if (rung.heavy_tails) return "  heavy tails";
  const bool is_seen = std::abs(rung.worth.value - 1) > kCounts * rung.worth.error;
  return is_seen || lowest ? "" : "  not seen";
}

std::string row(const Climbed& rung, bool lowest) {
  const std::string idea = rung.rung.kept ? rung.rung.idea : "(" + rung.rung.idea + ")";
  return fmt::format("  {:<36}{:>9.3g}{:>8.3g}{:>9.3g} %{:>16}{:>17}{:>9.3g}{}\n", idea,
                     1e6 * rung.seconds, rung.rays, 100 * std::sqrt(rung.error2.value),
                     lowest ? "" : factor(rung.worth), lowest ? "" : factor(rung.in_all),
                     rung.in_all_rays, remark(rung, lowest));
}

std::string best_text(const Ladder& ladder) {
  const Climbed* best = &ladder.rungs[0];
  for (const Climbed& each : ladder.rungs) {
    if (each.rung.kept && each.in_all.value > best->in_all.value) best = &each;
  }
  return fmt::format(
      "The best, with \"{}\": {}, -l {}, --survival {:g}{};\n{} times as cheap as the plainest.\n",
      best->rung.idea, best->rung.mixture, best->rung.light_samples, best->rung.way.survival,
      best->rung.adaptive ? ", adaptive" : "", factor(best->in_all));
}

std::string notes(const Ladder& ladder) {
  std::string text =
      "Worth is time x variance of the last rung before this one that is kept, divided by that of\n"
      "this one. Rungs in brackets are not kept. \"Not seen\": it differs from 1 by less than two\n"
      "standard errors. Engines change no picture: only their time is compared.\n"
      "The rungs are the short code of the reference and of right solutions. ./run render has "
      "faster "
      "forms of\n"
      "direct_lights and camera_ray: its best settings are those of ./run cheapest.\n";
  if (!ladder.chosen.hemisphere) {
    text +=
        "Hemisphere sampling would miss lights that have no surface: all rungs sample the "
        "lights.\n";
  }
  if (!ladder.chosen.rectangles) {
    text += "No light is a rectangle: none has its solid angle sampled.\n";
  }
  if (std::any_of(ladder.rungs.begin(), ladder.rungs.end(),
                  [](const Climbed& each) { return each.biased; })) {
    text +=
        "A rung that is biased shows another picture: hemisphere sampling misses lights without a\n"
        "surface, and adaptive sampling may stop too early.\n";
  }
  return text;
}

// The engines' rungs differ only in time, so rays mean nothing there.
const char* const kLadderChart = R"gp(set logscale y
set title "{}" noenhanced
set terminal svg size 860,520 font "sans-serif,13"
set ylabel "cost of the plainest renderer over the cost of this one"
set xtics rotate by -35 ({})
set xrange [-.5:{}]
set key top left
set bmargin 10
set rmargin 20
plot "ladder.csv" using 1:8:9 skip 1 with yerrorlines lc rgb "#0072b2" lw 2 pt 7 ps .6 title "time x variance", \
     "" using 1:10 skip 1 with linespoints lc rgb "#d55e00" lw 1.5 pt 5 ps .5 title "rays x variance"{}{})gp";

}  // namespace

std::string to_text(const Ladder& ladder, const Options& options) {
  std::string text = fmt::format(
      "{}, {} x {} pixels, at most {} bounces, {} samples per pixel: what an idea is worth\n\n"
      "  {:<36}{:>9}{:>8}{:>11}{:>16}{:>17}{:>9}\n  {:<36}{:>9}{:>8}{:>11}{:>16}{:>17}{:>9}\n",
      options.scene.string(), options.width, options.height, options.bounces, options.samples,
      "each rung adds one idea", "us per", "rays", "error", "worth", "in all", "in all,", "",
      "pixel", "", "", "", "", "rays");
  for (std::size_t k = 0; k < ladder.rungs.size(); ++k) text += row(ladder.rungs[k], k == 0);
  return text + "\n" + best_text(ladder) + notes(ladder);
}

void write_ladder(const Ladder& ladder, const Options& options) {
  const std::filesystem::path& folder = options.out;
  std::string csv =
      "rung,idea,mixture,seconds_per_pixel,rays_per_pixel,relmse,worth,in_all,in_all_error,"
      "in_all_rays,worth_error,worth_rays,samples_per_pixel,light_samples,survival\n";
  std::string names;
  for (std::size_t k = 0; k < ladder.rungs.size(); ++k) {
    const Climbed& rung = ladder.rungs[k];
    csv += fmt::format(
        "{},\"{}\",{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.3g},{:.6g},{:.3g},{:.6g},"
        "{:.6g},{},{:g}\n",
        k, rung.rung.idea, rung.rung.mixture, rung.seconds, rung.rays, rung.error2.value,
        rung.worth.value, rung.in_all.value, rung.in_all.error, rung.in_all_rays, rung.worth.error,
        rung.worth_rays, rung.samples, rung.rung.light_samples, rung.rung.way.survival);
    names += fmt::format("{}\"{}\" {}", k == 0 ? "" : ", ", rung.rung.idea, k);
  }
  pt::write_file(folder / "ladder.csv", csv);
  const std::string subject = fmt::format("{}, at most {} bounces, s = {}; {}", subject_of(options),
                                          options.bounces, options.samples, processor());
  draw(
      folder, "ladder",
      fmt::format(
          fmt::runtime(kLadderChart), subject, names, static_cast<double>(ladder.rungs.size()) - .5,
          under_the_pointer({"\"ladder.csv\" skip 1", "time x variance", "$1", "$8", "$8", "$9"}),
          under_the_pointer({"\"ladder.csv\" skip 1", "rays x variance", "$1", "$10", "$10", ""})),
      fmt::format("The cost of the plainest renderer over that of each better one: {}. {}", subject,
                  kErrorCaption));
}

}  // namespace measure::scene
