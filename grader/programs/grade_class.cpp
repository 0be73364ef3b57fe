// grade_class: grades every submission in a folder. Exit status 0 if all could be judged, 2 if one
// could not, or nothing could.
#include "grader/programs/class.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"

#include <cstdio>
#include <filesystem>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace grader;

struct Options {
  programs::ClassRequest request;
  std::string config;
  std::optional<std::uint64_t> seed;
  bool not_isolated = false;
};

void describe(CLI::App& app, Options& options) {
  programs::ClassRequest& request = options.request;
  app.add_option("folder", request.folder, "a folder with a folder per submission")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--out", request.out, "where reports go; default: <folder>-graded");
  app.add_option("--seed", options.seed,
                 "the seed of all random inputs; default: drawn for the class, and kept");
  app.add_flag("--not-isolated", options.not_isolated, "go on where nothing isolates submissions");
  app.add_option("--config", options.config, "what CMake wrote (grade.json)");
  app.prefix_command();
}

// `words`: what follows --.
int run(Options options, const std::vector<std::string>& words) {
  programs::ClassRequest& request = options.request;
  request.words = words;
  std::erase(request.words, "--");
  for (const std::string& word : request.words) {
    if (word.starts_with("--seed")) throw pt::Error("write --seed before --, not after it");
  }
  while (request.folder.size() > 1 && request.folder.back() == '/') request.folder.pop_back();
  if (request.out.empty()) request.out = request.folder + "-graded";
  if (options.config.empty()) options.config = judge::default_config_path();
  const judge::Config config = judge::load_config(options.config);
  request.grade = std::filesystem::path(options.config).parent_path() / "grade";
  if (!options.not_isolated) request.words.emplace_back("--require-isolation");
  std::filesystem::create_directories(request.out);
  const std::string table = request.out + "/class.csv";
  pt::check_target(table);
  request.seed = programs::seed_for(request.out, options.seed);
  fmt::print("seed {} (--seed {} gives the same verdicts again)\n", request.seed, request.seed);

  std::vector<programs::Graded> all;
  bool all_judged = true;
  const std::vector<std::string> names = programs::submissions_of(request.folder);
  for (const std::string& name : names) {
    all.push_back(programs::grade_one(config, request, name));
    const programs::Graded& last = all.back();
    fmt::print(
        "{}/{} {}: {}{}\n", all.size(), names.size(), results::one_line(name),
        last.problem.empty() ? results::verdict(last.results) : results::one_line(last.problem),
        last.again ? " (as before)" : "");
    std::fflush(stdout);
    all_judged = all_judged && last.problem.empty();
    pt::write_file(table, programs::class_table(config, all));
  }
  fmt::print("{}\n", table);
  return all_judged ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Grades every submission in a folder; options after -- go to grade",
               "./run grade-class"};
  describe(app, options);
  return pt::run_command_line(app, argc, argv, [&] { return run(options, app.remaining()); });
}
