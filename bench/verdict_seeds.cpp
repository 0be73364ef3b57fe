// Judges the reference's own pictures with one seed after the other, to find how often a right
// submission fails. Each verdict is a line of a CSV and is not made again, so the program can be
// stopped and started at any time. Exit status 1 if a picture failed.
#include "grader/base/parallel.h"
#include "grader/pictures/recipes/judge_recipe.h"
#include "pt/command_line.h"
#include "pt/error.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace grader;
using namespace grader::pictures;

struct Options {
  std::string root = FIRSTLIGHT_ROOT;
  std::string out = "build/verdict_seeds.csv";
  std::vector<std::string> names;
  int seeds = 200;
  int threads = 2;
};

struct Job {
  const pictures::Recipe* recipe;
  int seed;
};

// "recipe,seed" of every complete line.
std::set<std::string> done(const std::string& path) {
  std::set<std::string> all;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line) && !file.eof();) {
    const std::size_t comma = line.find(',');
    if (comma != std::string::npos) all.insert(line.substr(0, line.find(',', comma + 1)));
  }
  return all;
}

results::PictureResult judge(const Job& job, const Options& options) {
  const std::string golden = options.root + "/golden/" + job.recipe->name;
  pictures::Rendering rendering;
  rendering.rows = pt::render_rows;
  rendering.source = {"the reference", static_cast<std::uint64_t>(job.seed)};
  return pictures::judge_recipe(*job.recipe, rendering,
                                {golden + ".exr", golden + "_rates.json", "", "", "", ""});
}

int run(const Options& options) {
  const std::vector<pictures::Recipe> recipes =
      pictures::load_recipes(options.root + "/scenes/recipes.json");
  for (const std::string& name : options.names) pictures::find(recipes, name);
  const std::set<std::string> known = done(options.out);
  std::vector<Job> jobs;
  for (int seed = 1; seed <= options.seeds; ++seed) {
    for (const pictures::Recipe& recipe : recipes) {
      const bool asked = options.names.empty() ||
                         std::count(options.names.begin(), options.names.end(), recipe.name) > 0;
      if (asked && !known.contains(fmt::format("{},{}", recipe.name, seed))) {
        jobs.push_back({&recipe, seed});
      }
    }
  }
  std::ofstream csv(options.out, std::ios::app);
  if (!csv) throw pt::Error(options.out + ": cannot be written; choose another --out");
  std::size_t ended = 0, failed = 0, later = 0;
  std::mutex writing;
  base::for_each(jobs.size(), options.threads, [&](std::size_t i) {
    const results::PictureResult result = judge(jobs[i], options);
    const std::lock_guard lock(writing);
    failed += result.state == results::State::pass ? 0 : 1;
    later += result.rounds > 1 ? 1 : 0;
    csv << fmt::format("{},{},{},{},{:.3f},{:.3f},\"{}\"\n", jobs[i].recipe->name, jobs[i].seed,
                       name(result.state), result.rounds, result.noise, result.seconds, result.text)
        << std::flush;
    std::fprintf(stderr, "\r%zu of %zu, %zu needed a second round, %zu failed", ++ended,
                 jobs.size(), later, failed);
  });
  fmt::print("\n{} new verdicts, {} from earlier runs: {} failed, {} needed a second round\n",
             jobs.size(), known.size(), failed, later);
  return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Judges the reference's pictures with many seeds"};
  app.add_option("recipe", options.names, "Recipes; default: all");
  app.add_option("--seeds", options.seeds, "Seeds 1 to this")->check(CLI::PositiveNumber);
  app.add_option("--threads", options.threads, "Pictures at a time")->check(CLI::Range(1, 256));
  app.add_option("--out", options.out,
                 "The CSV: recipe, seed, state, rounds, noise, seconds, text");
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
