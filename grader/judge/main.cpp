// grade: judges a submission, and never runs a line of it itself. Exit status 0 if all that was
// asked for passes, 1 if something that was judged does not, 2 if nothing could be judged.
#include "grader/hints/memory.h"
#include "grader/judge/grade.h"
#include "grader/process/spawn.h"
#include "grader/report/json.h"
#include "grader/report/terminal.h"
#include "pt/error.h"

#include <csignal>
#include <cstdio>
#include <set>

#include <CLI/CLI.hpp>

namespace {

using namespace grader;

struct Options {
  std::vector<std::string> what;
  std::string submission = "student";
  std::string json;
  std::string config;
  std::uint64_t seed = 1;
  int call_limit = 2000;
  int compile_limit = 60;
  std::string isolation;
  bool require_isolation = false;
  bool all = false;
};

Isolation isolation(const Config& config, const Options& options) {
  std::optional<Tier> forced;
  if (!options.isolation.empty()) forced = tier_of(options.isolation);
  const Isolation found = probe_isolation(config.root, config.work, forced);
  if (options.require_isolation && found.tier == Tier::limits) {
    throw pt::Error("--require-isolation refuses to grade in C" +
                    (forced ? ", which was asked for" : ": " + found.why_not_better));
  }
  return found;
}

int run(const Options& options) {
  const Config config =
      load_config(options.config.empty() ? default_config_path() : options.config);
  GradeRequest request{options.submission, {}, options.seed, options.call_limit};
  request.compile_limit = options.compile_limit;
  request.isolation = isolation(config, options);
  std::set<std::string> asked;
  for (const std::string& word : options.what) {
    for (const std::string& slug : tasks_meant(config, word)) asked.insert(slug);
  }
  for (const TaskConfig& task : config.tasks) {
    if (options.what.empty() || asked.contains(task.slug)) request.asked.push_back(task.slug);
  }
  const Results results = grade(config, request, [&](const Results& so_far) {
    if (!options.json.empty()) write_json(so_far, options.json);
  });
  remember_failures(config.work, results);
  const std::string text = to_text(results, {terminal_has_color(), options.all});
  std::fputs(text.c_str(), stdout);
  return passes(results) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  Options options;
  CLI::App app{"Judges a submission: every task, or those asked for"};
  app.add_option("what", options.what, "tasks (hit_triangle), parts (1) or exercises (1.3)");
  app.add_option("--submission", options.submission, "a folder with the tree of student/")
      ->check(CLI::ExistingDirectory);
  app.add_flag("--all", options.all, "show every failure, not only the first");
  app.add_option("--json", options.json, "also write the results to this file");
  app.add_option("--seed", options.seed, "of all random inputs");
  app.add_option("--call-limit", options.call_limit, "milliseconds that one call may take")
      ->check(CLI::PositiveNumber);
  app.add_option("--compile-limit", options.compile_limit, "seconds that compiling a file may take")
      ->check(CLI::PositiveNumber);
  app.add_option("--isolation", options.isolation,
                 "A (bubblewrap), B (another user) or C (none); default: the best that works here");
  app.add_flag("--require-isolation", options.require_isolation, "refuse to grade in C");
  app.add_option("--config", options.config, "what CMake wrote (grade.json)");
  try {
    app.parse(argc, argv);
    return run(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
