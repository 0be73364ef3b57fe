// grade_class: grades every submission of a class. Exit status 0 if all could be judged, 2 if one
// could not, or nothing could.
#include "grader/base/parallel.h"
#include "grader/programs/class.h"
#include "grader/report/class_page.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <numeric>
#include <optional>
#include <thread>

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
  app.add_option("class", request.input,
                 "an export of Canvas, Moodle or Gradescope, or a folder with a folder or "
                 "an archive per submission")
      ->required()
      ->check(CLI::ExistingPath);
  app.add_option("--out", request.out, "where reports go; default: <class>-graded");
  app.add_option("--jobs", request.jobs,
                 "submissions at a time; verdicts do not depend on it; default: one per processor")
      ->check(CLI::Range(1, 256));
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
  while (request.input.size() > 1 && request.input.back() == '/') request.input.pop_back();
  if (request.out.empty()) request.out = request.input + "-graded";
  if (options.config.empty()) options.config = judge::default_config_path();
  const judge::Config config = judge::load_config(options.config);
  request.grade = std::filesystem::path(options.config).parent_path() / "grade";
  if (!options.not_isolated) request.words.emplace_back("--require-isolation");
  std::filesystem::create_directories(request.out);
  const std::string table = request.out + "/class.csv";
  pt::check_target(table);
  request.seed = programs::seed_for(request.out, options.seed);
  fmt::print("seed {} (--seed {} gives the same verdicts again)\n", request.seed, request.seed);

  const std::vector<intake::HandedIn> everybody = programs::handed_in(request);
  std::vector<std::string> lines(everybody.size());
  report::ClassPage page;
  programs::Returns returns;
  std::mutex mutex;
  bool all_judged = true;
  std::size_t count = 0;
  base::for_each(everybody.size(), request.jobs, [&](std::size_t i) {
    const programs::Graded graded = programs::grade_one(config, request, everybody[i]);
    const std::lock_guard lock(mutex);
    fmt::print("{}/{} {}: {}{}\n", ++count, everybody.size(), results::one_line(graded.by.name),
               graded.problem.empty() ? results::verdict(graded.results)
                                      : results::one_line(graded.problem),
               graded.again ? " (as before)" : "");
    std::fflush(stdout);
    all_judged = all_judged && graded.problem.empty();
    page.add(
        {graded.by.name, graded.by.id, graded.by.name + ".html", graded.problem, graded.by.late},
        graded.results);
    returns.add(graded);
    lines[i] = programs::class_line(config, graded);
    pt::write_file(table,
                   std::accumulate(lines.begin(), lines.end(), programs::class_header(config)));
  });
  const std::string overview = request.out + "/class.html";
  pt::write_file(overview, page.to_html());
  fmt::print("{}\n{}\n", table, overview);
  for (const std::string& file : returns.write(request)) fmt::print("{}\n", file);
  return all_judged ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.request.jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  CLI::App app{"Grades every submission of a class; options after -- go to grade",
               "./run grade-class"};
  describe(app, options);
  return pt::run_command_line(app, argc, argv, [&] { return run(options, app.remaining()); });
}
