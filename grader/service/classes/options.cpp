#include "grader/service/classes/options.h"

#include <map>

#include <CLI/CLI.hpp>

namespace grader::classes {

namespace {

constexpr const char* kSteps =
    "One step at a time, for other schedulers than --engine knows:\n"
    "  ./run grade-class plan CLASS --out DIR [--chunk-size N] ... [-- OPTIONS of grade]\n"
    "  ./run grade-class chunk DIR NUMBER ...      on any machine that has DIR; in any order\n"
    "  ./run grade-class collect DIR               at any time: tables and pages of what is "
    "judged\n"
    "A class whose folder has one of these names is written ./plan.";

void add_config(CLI::App& app, ClassOptions& options) {
  app.add_option("--config", options.config, "what CMake wrote (grade.json)");
}

void add_reports(CLI::App& app, ClassOptions& options) {
  app.add_option("reports", options.plan.out, "the folder with the plan")
      ->required()
      ->check(CLI::ExistingDirectory);
  add_config(app, options);
}

}  // namespace

void describe_plan(CLI::App& app, ClassOptions& options) {
  app.add_option("class", options.plan.input,
                 "an export of Canvas, Moodle or Gradescope, or a folder with a folder or "
                 "an archive per submission")
      ->required()
      ->check(CLI::ExistingPath);
  app.add_option("--out", options.plan.out, "where reports go; default: <class>-graded");
  app.add_option("--seed", options.plan.seed,
                 "the seed of all random inputs; default: drawn for the class, and kept");
  app.add_option("--chunk-size", options.plan.chunk_size,
                 "submissions that one process judges; default: as many as give 500 chunks");
  app.add_option(
         "--compare", options.plan.former,
         "reports of an earlier grading: who gains, who loses, and by which promise; judges "
         "with its seed, and only what may have changed")
      ->check(CLI::ExistingDirectory);
  app.add_option("--assignment", options.plan.assignment,
                 "the column in canvas.csv, as Canvas writes it: \"Rays (1234)\"; default: the "
                 "export's name, which Canvas takes for a new one");
  app.add_option("--worksheet", options.plan.worksheet,
                 "the grading worksheet that Moodle exported, to be filled in: moodle.csv is then "
                 "that file with the grades; default: one that holds the submissions only")
      ->check(CLI::ExistingFile);
  app.add_option(
      "--roster", options.plan.rules.roster,
      "everybody in the class, a CSV file with the columns id or name, and perhaps due (an "
      "extension) and handed_in: who has handed in nothing gets a row and 0 points");
  app.add_option("--due", options.plan.rules.due,
                 "until when to hand in, as \"2027-01-15 22:00\"; what came later is late");
  app.add_option("--grace", options.plan.rules.grace,
                 "minutes after --due that are forgiven; default: 0")
      ->check(CLI::Range(0, 1000000));
  app.add_option("--penalty", options.plan.rules.penalty,
                 "percent of the points that each day takes that has begun after --due; default: 0")
      ->check(CLI::Range(0, 100));
  app.add_option("--attempt", options.plan.rules.attempt,
                 "which counts of several attempts in the export: last, task by task, or first; "
                 "default: last")
      ->check(CLI::IsMember({"last", "first"}));
  app.add_option("--overrides", options.plan.rules.overrides,
                 "points by hand, a CSV file with the columns id or name, points and word. These "
                 "six stay until "
                 "another call names others; --overrides '' ends them");
  app.add_option("--forms", options.plan.forms,
                 "how another platform names what is handed in: a CSV file with the columns "
                 "platform and pattern, "
                 "as {name}_{id}_{file}")
      ->check(CLI::ExistingFile);
  app.add_flag("--anonymous", options.plan.anonymous,
               "numbers in place of names; names.csv tells who is who");
  app.add_flag("--no-likeness", options.plan.no_likeness,
               "no likeness.html, which shows what is alike in the class");
  app.add_flag("--not-isolated", options.not_isolated, "go on where nothing isolates submissions");
  add_config(app, options);
  app.prefix_command();
}

void describe_class(CLI::App& app, ClassOptions& options) {
  app.footer(kSteps);
  const std::map<std::string, Engine> engines{
      {"local", Engine::local}, {"parallel", Engine::parallel}, {"slurm", Engine::slurm}};
  app.add_option("--jobs", options.engine.jobs,
                 "submissions at a time; verdicts do not depend on it; default: one per processor")
      ->check(CLI::Range(1, 4096));
  app.add_option("--engine", options.engine.engine,
                 "where: local (this machine), parallel (GNU parallel) or slurm (an array job)")
      ->transform(CLI::Transformer(engines).description("local|parallel|slurm"));
  app.add_option(
         "--engine-option", options.engine.options,
         "a word for parallel or sbatch, as --engine-option=--sshlogin=a,b; may be repeated")
      ->allow_extra_args(false);
  describe_plan(app, options);
}

void describe_chunk(CLI::App& app, ClassOptions& options) {
  add_reports(app, options);
  app.add_option("number", options.numbers, "of the chunks, from 1 on")->required();
  app.add_option("--jobs", options.engine.jobs, "submissions at a time; default: 1")
      ->check(CLI::Range(1, 4096));
  app.add_flag("--end-with-parent", options.end_with_parent,
               "for engines: it ends when the process that started it does");
}

void describe_collect(CLI::App& app, ClassOptions& options) { add_reports(app, options); }

}  // namespace grader::classes
