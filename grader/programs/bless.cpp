// bless: renders the goldens by which submissions are judged, with the linked tasks. Exit status 1
// if a golden is wrong, missing or contradicts the golden that it would replace, 2 if the arguments
// cannot be used.
#include "grader/pictures/goldens/check_golden.h"
#include "grader/pictures/goldens/contact_sheet.h"
#include "grader/pictures/goldens/make_golden.h"
#include "grader/pictures/goldens/provenance.h"
#include "grader/pictures/recipes/seeds.h"
#include "grader/pictures/statistics/image_verdict.h"
#include "grader/pictures/statistics/sample_map_verdict.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/image/image_io.h"
#include "pt/render/progress.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

namespace fs = std::filesystem;
using namespace grader;

struct Options {
  std::vector<std::string> names;
  std::string because;
  bool check = false;
  bool again = false;
  bool table = false;
  fs::path recipes = "scenes/recipes.json";
  fs::path folder = "golden";
  fs::path work = "build/bless";
  std::string commit = "unknown";
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  int samples = 0;  // per pixel, or runs; 0 for as many as a golden needs
};

pictures::Effort effort_of(const pictures::Recipe& recipe, const Options& options) {
  if (options.samples == 0) return pictures::usual_effort(recipe);
  return recipe.adaptive ? pictures::Effort{options.samples, 1}
                         : pictures::Effort{2, options.samples / 2};
}

// The shortest command that makes this golden again.
std::string command_for(const pictures::Recipe& recipe, const Options& options) {
  const std::string samples =
      options.samples == 0 ? "" : fmt::format(" --samples {}", options.samples);
  return fmt::format("./run bless {}{}", recipe.name, samples);
}

pictures::Provenance provenance_of(const pictures::Recipe& recipe,
                                   const pictures::GoldenState& state, const Options& options) {
  return {recipe.name,
          command_for(recipe, options),
          options.commit,
          pictures::golden_seed(recipe, 0),
          state.parts,
          state.parts * state.samples,
          state.cpu_seconds,
          {},
          pictures::recipe_settings(recipe),
          pictures::picture_hash(recipe),
          {}};
}

bool is_up_to_date(const pictures::Recipe& recipe, const pictures::Effort& effort,
                   const fs::path& folder) {
  const pictures::GoldenFiles files = pictures::golden_files(folder, recipe.name);
  if (!fs::exists(files.film) || (recipe.adaptive && !fs::exists(files.rates))) return false;
  try {
    const pictures::Provenance provenance = pictures::read_provenance(files.provenance);
    return provenance.sha256 == pictures::picture_hash(recipe) &&
           provenance.files == pictures::hash_of(files) &&
           provenance.first_seed == pictures::golden_seed(recipe, 0) &&
           provenance.samples >= effort.parts * effort.samples;
  } catch (const pt::Error&) {
    return false;  // missing or broken: it has to be made again
  }
}

// The reason why the old golden cannot be right if the new one is; empty if there is no old golden
// or they agree.
std::string contradiction(const pictures::Recipe& recipe, const pt::Film& film,
                          const fs::path& folder) {
  const fs::path file = pictures::golden_files(folder, recipe.name).film;
  if (!fs::exists(file)) return {};
  const pt::Film older = pt::read_exr(file);
  if (older.width != film.width || older.height != film.height) {
    return fmt::format("it was {} x {} and is {} x {} now", older.width, older.height, film.width,
                       film.height);
  }
  const std::vector<results::FailingCell> cells = pictures::contradictions(older, film);
  if (cells.empty()) return {};
  const results::FailingCell& worst = cells.front();
  return fmt::format("the {} x {} pixels at ({}, {}) from the top left are {:.2f} % {} in {}",
                     worst.width, worst.height, worst.x, worst.y, 100 * std::abs(worst.off_by),
                     worst.off_by < 0 ? "darker" : "brighter", worst.channel);
}

// Writes the film before its provenance: a film without its own provenance is made again.
void write_golden(const pictures::Recipe& recipe, const pictures::GoldenState& state,
                  const pt::Film& film, pictures::Provenance provenance, const Options& options) {
  const pictures::GoldenFiles files = pictures::golden_files(options.folder, recipe.name);
  if (recipe.adaptive) {
    auto reference =
        pictures::reference_of(pictures::maps_of(recipe, state), film, *recipe.adaptive);
    reference.dark_start = pictures::dark_starts(recipe, reference.runs, options.threads);
    pictures::write_reference(files.rates, reference);
  }
  fs::remove(files.provenance);
  pt::write_exr(files.film, film);
  provenance.files = pictures::hash_of(files);
  pictures::write_provenance(files.provenance, provenance);
}

bool agrees_with_theory(const pictures::Recipe& recipe, const pt::Film& film) {
  if (!recipe.uniform) return true;
  const std::vector<std::string> errors = pictures::against_closed_form(film, *recipe.uniform);
  for (const std::string& each : errors) fmt::print(stderr, "{}: {}\n", recipe.name, each);
  return errors.empty();
}

void refuse(const pictures::Recipe& recipe, const std::string& why) {
  fmt::print(
      stderr,
      "{}: the new golden contradicts the old one, which stays: {}. If the old one is wrong, "
      "say so: ./run bless {} --because \"...\"\n",
      recipe.name, why, recipe.name);
}

// Returns whether the golden is now in the folder.
bool bless(const pictures::Recipe& recipe, const Options& options) {
  const pictures::Effort effort = effort_of(recipe, options);
  if (!options.again && is_up_to_date(recipe, effort, options.folder)) {
    fmt::print("{}: is up to date\n", recipe.name);
    return true;
  }
  const fs::path partial = options.work / (recipe.name + ".partial");
  pt::Progress progress;
  const pictures::GoldenState state = pictures::render_golden(
      recipe, effort, options.threads, partial, [&](double part) { progress.show(part); });
  progress.clear();
  const pt::Film film = pictures::film_of(recipe, state);
  if (!agrees_with_theory(recipe, film)) return false;
  const std::string why = contradiction(recipe, film, options.folder);
  if (!why.empty() && options.because.empty()) {
    refuse(recipe, why);
    return false;
  }
  pictures::Provenance provenance = provenance_of(recipe, state, options);
  if (!why.empty()) provenance.because = options.because;  // a reason that nobody needs is dropped
  write_golden(recipe, state, film, provenance, options);
  fs::remove(partial);
  fmt::print("{}: {} samples per pixel in {:.0f} CPU seconds\n", recipe.name, provenance.samples,
             provenance.cpu_seconds);
  return true;
}

int run(const Options& options) {
  const std::vector<pictures::Recipe> all = pictures::load_recipes(options.recipes);
  if (options.check) {
    const std::vector<std::string> found = pictures::check_goldens(all, options.folder);
    for (const std::string& each : found) fmt::print(stderr, "{}\n", each);
    if (found.empty()) fmt::print("{} goldens agree with their recipes\n", all.size());
    return found.empty() ? 0 : 1;
  }
  if (options.table) {
    fmt::print("{}", pictures::golden_table(all, options.folder));
    return 0;
  }
  std::vector<pictures::Recipe> asked;
  for (const std::string& name : options.names) asked.push_back(pictures::find(all, name));
  fs::create_directories(options.folder);
  fs::create_directories(options.work);
  bool all_blessed = true;
  for (const pictures::Recipe& recipe : asked.empty() ? all : asked) {
    all_blessed = bless(recipe, options) && all_blessed;
    std::fflush(stdout);
  }
  pt::write_png(options.folder / pictures::kSheetName,
                pictures::contact_sheet(all, options.folder));
  return all_blessed ? 0 : 1;
}

void describe(CLI::App& app, Options& options) {
  app.add_option("recipe", options.names, "Recipes; default: all whose golden is out of date");
  app.add_option("--because", options.because,
                 "Why a golden may replace one that it contradicts; kept with it");
  app.add_flag("--again", options.again, "Also goldens that are up to date: for a new reference");
  app.add_flag("--check", options.check,
               "Render nothing; list the goldens that are missing, out of date or wrong");
  app.add_flag("--table", options.table, "Render nothing; print the table of docs/recipes.md");
  app.add_option("-t,--threads", options.threads, "Default: one per processor")
      ->check(CLI::Range(1, 1024));
  app.add_option("--samples", options.samples, "Samples per pixel, or runs: fewer, for a test")
      ->check(CLI::Range(8, 1 << 20));
  app.add_option("--recipes", options.recipes, "The file of recipes");
  app.add_option("--golden", options.folder, "The folder of goldens");
  app.add_option("--work", options.work, "The folder of half-finished goldens");
  app.add_option("--commit", options.commit, "The commit that renders, for the provenance");
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Makes the goldens by which submissions are judged.", "./run bless");
  describe(app, options);
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
