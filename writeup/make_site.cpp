#include "writeup/make_site.h"

#include "grader/base/files.h"
#include "grader/base/parallel.h"
#include "grader/base/sha256.h"
#include "grader/report/csv.h"
#include "measure/charts/gnuplot.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/render/progress.h"
#include "writeup/work.h"

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace writeup {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxDrawn = std::size_t{1} << 24;
constexpr double kDraftPatience = 5;

// The renders of these figures that are not settled, each once.
std::vector<Unit> missing_units(const Plan& plan, const std::vector<const Figure*>& figures) {
  std::vector<Unit> units;
  std::set<std::string> keys;
  for (const Figure* figure : figures) {
    for (const Unit& unit : plan.units(*figure)) {
      if (keys.insert(plan.store().key(unit)).second && !plan.store().is_settled(unit)) {
        units.push_back(unit);
      }
    }
  }
  return units;
}

// The measurements of these figures that are not settled, each once.
std::vector<Measurement> missing_measurements(const Plan& plan,
                                              const std::vector<const Figure*>& figures) {
  std::vector<Measurement> missing;
  std::set<std::string> keys;
  for (const Figure* figure : figures) {
    for (const Measurement& each : plan.measurements(*figure)) {
      if (keys.insert(plan.measured().key(each)).second && !plan.measured().is_settled(each)) {
        missing.push_back(each);
      }
    }
  }
  return missing;
}

// Seconds that the renders and the measurements take, about.
struct Time {
  double renders = 0, measurements = 0;
};

Time expected_time(const Plan& plan, const std::vector<Unit>& units,
                   const std::vector<Measurement>& measurements, int threads) {
  Time time;
  for (const Unit& unit : units) time.renders += plan.store().seconds(unit) / threads;
  time.measurements = seconds_by_the_clock(measurements, threads);
  return time;
}

void print_plan(const Plan& plan, const std::vector<const Figure*>& figures,
                const std::vector<Unit>& units, const std::vector<Measurement>& measurements,
                const Time& time, int threads) {
  int unsettled = 0;
  for (const Figure* figure : figures) unsettled += is_settled(plan, *figure) ? 0 : 1;
  fmt::print(
      "{} of {} figures to make, {} renders and {} measurements: about {:.1f} minutes on {} "
      "processors\n",
      unsettled, figures.size(), units.size(), measurements.size(),
      (time.renders + time.measurements) / 60, threads);
  std::fflush(stdout);
}

// Everything that the look of a figure depends on.
std::string drawing_key(const Plan& plan, const Figure& figure) {
  std::string text = figure.source + grader::base::stamp("/proc/self/exe");
  for (const std::string& scene : figure.scenes) text += plan.scenes().description(scene);
  for (const Picture& picture : figure.pictures) text += plan.unavailable(picture);
  for (const Unit& unit : plan.units(figure)) {
    text += fmt::format("{} {} {} {} ", plan.store().key(unit), unit.range, unit.spec.scene,
                        plan.store().failure(unit));
  }
  for (const Measurement& each : plan.measurements(figure)) {
    text += plan.measured().key(each) + plan.measured().failure(each);
  }
  return grader::base::sha256(text).substr(0, 32);
}

Drawn draw(const Plan& plan, const Figure& figure, const fs::path& folder) {
  if (figure.kind == "speedup") return draw_speedup(plan, figure, folder);
  if (figure.kind == "pictures") return draw_pictures(plan, figure, folder);
  if (figure.kind == "rules") return draw_rules(plan, figure, folder);
  if (figure.kind == "curve") return draw_curve(plan, figure, folder);
  if (figure.kind == "prices") return draw_prices(plan, figure, folder);
  if (figure.kind == "path") return draw_path(plan, figure, folder);
  if (figure.kind == "ray") return draw_ray(plan, figure, folder);
  return draw_measured(plan, figure, folder);
}

// The figure's pictures for LaTeX, and its numbers as the texts name them.
void add_for_papers(const Plan& plan, const Figure& figure, const fs::path& folder, Drawn& drawn) {
  std::vector<std::string> files;
  std::string caption = figure.title + ".";
  std::set<std::string> scenes;
  for (const Picture& picture : figure.pictures) {
    scenes.insert(plan.scenes().description(picture.scene));
  }
  for (const Shown& shown : drawn.pictures) {
    if (shown.file.empty()) continue;
    files.push_back(shown.file + ".png");
    caption += fmt::format("{} {} ({})", files.size() == 1 ? " From left to right:" : ";",
                           shown.label, shown.facts);
  }
  if (!files.empty()) {
    caption += fmt::format(". {}", fmt::join(scenes, "; "));
    pt::write_file(folder / (figure.id + ".tex"), measure::latex_figure(files, caption + "."));
    drawn.tables.push_back(figure.id + ".tex");
  }
  if (drawn.numbers.empty()) return;
  std::string csv = "number,value\n";
  for (const auto& [name, value] : drawn.numbers) {
    csv += name + ',' + grader::report::csv_field(value) + '\n';
  }
  pt::write_file(folder / (figure.id + ".numbers.csv"), csv);
  drawn.tables.push_back(figure.id + ".numbers.csv");
}

Drawn drawn_figure(const Plan& plan, const Figure& figure, const fs::path& folder) {
  const fs::path kept = folder / "figure.json";
  if (fs::exists(kept)) {
    return nlohmann::json::parse(pt::read_file(kept, kMaxDrawn)).get<Drawn>();
  }
  fs::create_directories(folder);
  Drawn drawn = draw(plan, figure, folder);
  drawn.seconds = plan.seconds(figure);
  add_for_papers(plan, figure, folder, drawn);
  pt::write_file(kept, nlohmann::json(drawn).dump());
  return drawn;
}

// Links the missing files, or copies them if the folder is on another disk.
void publish(const fs::path& from, const fs::path& to) {
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    const fs::path target = to / entry.path().filename();
    std::error_code error;
    if (entry.path().extension() == ".json" || fs::equivalent(entry.path(), target, error))
      continue;
    fs::remove(target);
    fs::create_hard_link(entry.path(), target, error);
    if (error) fs::copy_file(entry.path(), target);
  }
}

}  // namespace

std::vector<const Figure*> figures_meant(const Catalogue& catalogue,
                                         const std::vector<std::string>& words) {
  std::vector<const Figure*> figures;
  for (const Figure& figure : catalogue.figures) {
    const auto named = [&](const std::string& word) {
      return word == figure.id || word == figure.part || word == "part" + figure.part;
    };
    if (words.empty() || std::any_of(words.begin(), words.end(), named)) figures.push_back(&figure);
  }
  for (const std::string& word : words) {
    const bool known =
        std::any_of(catalogue.figures.begin(), catalogue.figures.end(), [&](const Figure& figure) {
          return word == figure.id || word == figure.part || word == "part" + figure.part;
        });
    if (!known) {
      throw pt::Error("there is no part and no figure '" + word +
                      "'; ./run writeup --list has all");
    }
  }
  return figures;
}

bool is_settled(const Plan& plan, const Figure& figure) {
  const std::vector<Unit> units = plan.units(figure);
  return std::all_of(units.begin(), units.end(),
                     [&](const Unit& unit) { return plan.store().is_settled(unit); }) &&
         missing_measurements(plan, {&figure}).empty();
}

bool make_missing(const Plan& plan, const std::vector<const Figure*>& figures,
                  const Options& options) {
  std::vector<Unit> units = missing_units(plan, figures);
  const std::vector<Measurement> measurements = missing_measurements(plan, figures);
  if (units.empty() && measurements.empty()) return false;
  const Time time = expected_time(plan, units, measurements, options.threads);
  print_plan(plan, figures, units, measurements, time, options.threads);
  const double renders = time.renders / (time.renders + time.measurements);  // their part of all
  pt::Progress progress;
  // Some renders are settled only when the times of others are known.
  double done = 0;
  while (!units.empty()) {
    WorkSettings settings;
    settings.threads = options.threads;
    if (options.draft) settings.least_seconds = kDraftPatience;
    settings.progress = [&](double part) { progress.show(std::max(done, renders * part)); };
    make(plan.store(), units, settings);
    done = renders;
    units = missing_units(plan, figures);
  }
  // Measurements of time come last, when nothing else runs.
  make(plan.measured(), measurements, options.threads,
       [&](double part) { progress.show(renders + (1 - renders) * part); });
  progress.clear();
  return true;
}

std::map<std::string, Drawn> draw_figures(const Plan& plan, const Catalogue& catalogue,
                                          const fs::path& drawn, const fs::path& folder,
                                          int threads) {
  fs::create_directories(folder);
  std::map<std::string, Drawn> figures;
  std::mutex mutex;
  grader::base::for_each(catalogue.figures.size(), threads, [&](std::size_t i) {
    const Figure& figure = catalogue.figures[i];
    if (!plan.is_prepared(figure) || !is_settled(plan, figure)) return;
    const fs::path files = drawn / drawing_key(plan, figure);
    Drawn result = drawn_figure(plan, figure, files);
    publish(files, folder);
    const std::lock_guard lock(mutex);
    figures[figure.id] = std::move(result);
  });
  return figures;
}

}  // namespace writeup
