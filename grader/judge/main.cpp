// grade: judges a submission, and never runs a line of it itself. Exit status 0 if all that was
// asked for passes, 1 if something that was judged does not, 2 if nothing could be judged.
#include "grader/hints/memory.h"
#include "grader/judge/grade.h"
#include "grader/process/spawn.h"
#include "grader/report/read_json.h"
#include "grader/report/terminal.h"
#include "grader/report/write_reports.h"
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
  ReportFiles files;
  std::string from_results;
  std::string config;
  std::uint64_t seed = 1;
  int call_limit = 2000;
  bool all = false;
};

int show(const Results& results, const Options& options) {
  const std::string text = to_text(results, {terminal_has_color(), options.all});
  std::fputs(text.c_str(), stdout);
  return results.complete && passes(results) ? 0 : 1;
}

int report_again(const Options& options) {
  const Results results = read_results(options.from_results);
  write_reports(results, options.files);
  return show(results, options);
}

int run(const Options& options) {
  check_targets(options.files);
  if (!options.from_results.empty()) return report_again(options);
  const Config config =
      load_config(options.config.empty() ? default_config_path() : options.config);
  GradeRequest request{options.submission, {}, options.seed, options.call_limit};
  std::set<std::string> asked;
  for (const std::string& word : options.what) {
    for (const std::string& slug : tasks_meant(config, word)) asked.insert(slug);
  }
  for (const TaskConfig& task : config.tasks) {
    if (options.what.empty() || asked.contains(task.slug)) request.asked.push_back(task.slug);
  }
  ProgressReports reports(options.files);
  const Results results =
      grade(config, request, [&](const Results& so_far) { reports.write(so_far); });
  remember_failures(config.work, results);
  return show(results, options);
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
  app.add_option("--json", options.files.json, "also write the results to this file");
  app.add_option("--html", options.files.html, "also write a page with all pictures");
  app.add_option("--junit", options.files.junit, "also write JUnit's XML");
  app.add_option("--gradescope", options.files.gradescope, "also write Gradescope's results.json");
  app.add_option("--csv", options.files.csv, "also write a table, a line a task");
  app.add_option("--from-results", options.from_results, "judge nothing: report what --json wrote");
  app.add_option("--seed", options.seed, "of all random inputs");
  app.add_option("--call-limit", options.call_limit, "milliseconds that one call may take")
      ->check(CLI::PositiveNumber);
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
