#include "grader/programs/grade_options.h"

#include "grader/report/autograders.h"
#include "pt/command_line.h"

#include <CLI/CLI.hpp>

namespace grader::programs {

std::string command(const GradeOptions& options) {
  std::string words = "./run grade";
  for (const std::string& word : options.what) words += " " + word;
  const bool is_learners = options.submission == "student" || !options.name.empty();
  if (!is_learners) words += " --submission " + options.submission;
  if (options.dialect == "none") words += " --dialect none";
  if (options.no_pictures) words += " --no-pictures";
  return words + " --seed " + std::to_string(options.seed);
}

GradeOptions parse_options(const std::vector<std::string>& words) {
  GradeOptions options;
  CLI::App app{"Judges a submission: every task, or those asked for", "./run grade"};
  app.add_option("what", options.what, "Tasks (hit_triangle), parts (1) or exercises (1.3)");
  CLI::Option* submission =
      app.add_option("--submission", options.submission,
                     "A folder or an archive with the task files, however they lie in it, or a "
                     "clone of CS184's skeleton")
          ->check(CLI::ExistingPath);
  app.add_option("--name", options.name,
                 "Who handed it in: reports show this instead of a path of this machine");
  app.add_flag("--all", options.all, "Show every failure, not only the first");
  app.add_flag("--quiet", options.quiet, "Do not show progress on standard error");
  app.add_flag("--no-pictures", options.no_pictures, "Judge the promises only");
  app.add_option("--json", options.files.json, "Also write the results to this file");
  app.add_option("--html", options.files.html, "Also write a page with all pictures");
  app.add_flag("--small-page", options.files.small_page,
               "Leave the values of pixels, and the maps of right pictures, out of that page");
  app.add_option("--junit", options.files.junit, "Also write JUnit's XML");
  for (const report::Autograder& each : report::kAutograders) {
    app.add_option(std::string("--") + each.name, options.files.autograders[each.name],
                   std::string("Also write ") + each.words);
  }
  app.add_option("--csv", options.files.csv, "Also write a table, a line per task");
  app.add_option("--from-results", options.from_results, "Judge nothing: report what --json wrote");
  app.add_option("--seed", options.seed, "The seed of all random inputs");
  app.add_option("--call-limit", options.call_limit, "Milliseconds that one call may take")
      ->check(CLI::PositiveNumber);
  app.add_option("--compile-limit", options.compile_limit, "Seconds that compiling a file may take")
      ->check(CLI::PositiveNumber);
  app.add_option("--threads", options.threads, "How many jobs run at the same time")
      ->check(CLI::Range(1, 256));
  app.add_option(
      "--isolation", options.isolation,
      "A (bubblewrap), B (another user) or C (limits); default: the best that works here");
  app.add_flag("--require-isolation", options.require_isolation,
               "Stop if only tier C (limits) works");
  app.add_option("--dialect", options.dialect,
                 "Of a clone of the course's skeleton, judge what the course asks for, or, with "
                 "none, our contracts")
      ->check(CLI::IsMember({"course", "none"}));
  app.add_flag("--resume", options.resume, "Continue the run that was interrupted");
  app.add_option("--note", options.note, "Which of the files handed in are in it")->group("");
  app.add_option("--course", options.course, "The clone's skeleton is that of this year")
      ->check(CLI::IsMember({"2019", "2020", "2022", "2023"}))
      ->group("");
  app.add_option("--take-to", options.take_to, "Write the task files to this folder")->group("");
  app.add_flag("--programs", options.programs, "Name the programs for ./run")->group("");
  app.add_option("--config", options.config, "What CMake wrote (grade.json)");
  app.add_option("--work", options.work,
                 "The folder of compiled files and known results; default: as --config says");
  std::vector<std::string> reversed(words.rbegin(), words.rend());
  pt::parse(app, reversed);
  options.is_named = submission->count() > 0;
  return options;
}

}  // namespace grader::programs
