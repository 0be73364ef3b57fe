#include "measure/calls/options.h"

#include "measure/charts/labels.h"
#include "pt/command_line.h"
#include "pt/error.h"

#include <CLI/CLI.hpp>

namespace measure::calls {

namespace fs = std::filesystem;

namespace {

const char* kFooter =
    "Each runs in a process of its own, in the box of ./run grade, and takes turns with the others "
    "in short\nbatches. A task is compared with the reference and with other right solutions;\n"
    "* marks those that no other one beats in both time and error.\n\nExit codes: 0 measured, 1 "
    "your own code "
    "has no numbers or is wrong, 2 the arguments cannot be used.\n\nExamples:\n"
    "  ./run measure --list\n"
    "  ./run measure hit_sphere --from student\n"
    "  ./run measure hit_sphere.half_b hit_sphere.textbook\n"
    "  ./run measure 3 --submission DIR --out charts\n"
    "  ./run measure hit_bvh --submission anna --submission ben\n";

// A mistake of the task: its folder in the whole project, its object in a handout.
fs::path mistake_named(const fs::path& root, const std::string& slug, const std::string& name) {
  fs::path folder = root / "build/mistakes" / slug / name;
  if (fs::is_directory(folder)) return folder;
  return root / "reference-objects/mistakes" / (slug + "." + name + ".o");
}

// "student", "hit_sphere=student", or "hit_bvh=first_child_that_hits".
void add_from(const std::string& word, const fs::path& root, Options& options) {
  const std::size_t equals = word.find('=');
  const std::string slug = equals == std::string::npos ? "" : word.substr(0, equals);
  const std::string name = equals == std::string::npos ? word : word.substr(equals + 1);
  const bool is_name = !name.empty() && name.find_first_of("./") == std::string::npos;
  const bool is_task = !slug.empty() && fs::exists(root / "pt/tasks" / (slug + ".h"));
  fs::path from = root / name;
  if (is_task && !fs::is_directory(from)) from = mistake_named(root, slug, name);
  if (!is_name || !fs::exists(from) || (!slug.empty() && !is_task)) {
    const bool is_handout = fs::exists(root / "reference-objects");
    throw pt::Error(
        "--from takes an implementation like student, or hit_sphere=student, or a mistake like "
        "hit_bvh=first_child_that_hits (" +
        std::string(is_handout ? "reference-objects/mistakes" : "build/mistakes") +
        " has their names), not '" + word + "'; another folder is measured with --submission");
  }
  if (name != "reference") options.own.push_back({slug, from.string(), labels_of({from})[0]});
}

}  // namespace

Options parse_options(int argc, const char* const* argv, const fs::path& root) {
  Options options;
  std::vector<std::string> from;
  std::string out;
  CLI::App app("Measures tasks: how long a call takes, and its error or its noise.",
               "./run measure");
  app.footer(kFooter);
  app.add_option(
      "what", options.what,
      "Tasks (hit_sphere), parts (1), or the right solutions of a task (hit_sphere.half_b); "
      "default: all");
  app.add_option("--from", from,
                 "Also your own code: student, or hit_sphere=student; or a mistake: hit_bvh=NAME")
      ->allow_extra_args(false);
  app.add_option(
         "--submission", options.submissions,
         "Also somebody's: a folder, an archive, or a clone of CS184's skeleton; up to four")
      ->allow_extra_args(false)
      ->check(CLI::ExistingPath);
  app.add_option(
         "--seconds", options.seconds,
         "How long to measure, besides compiling; more is more exact. Default: 40 for a task, "
         "20 for each of several")
      ->check(CLI::Range(1, 36000));
  app.add_option("--out", out, "A folder for charts and measure.csv; default: none");
  app.add_option("--isolation", options.isolation, "A, B or C, as ./run grade has it");
  pt::parse(app, argc, argv);
  options.out = out;
  if (!options.submissions.empty() && !from.empty()) {
    throw pt::Error("--from and --submission are two ways to name one thing: leave one out");
  }
  for (const std::string& word : from) add_from(word, root, options);
  // The learners' edition has no right solutions, so its default is the learner's own code.
  if (from.empty() && options.submissions.empty() && !fs::exists(root / "reference"))
    add_from("student", root, options);
  return options;
}

}  // namespace measure::calls
