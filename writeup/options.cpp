#include "writeup/options.h"

#include "pt/command_line.h"

#include <algorithm>
#include <thread>

#include <CLI/CLI.hpp>

namespace writeup {

namespace {

const char* const kFooter =
    "Examples:\n"
    "  ./run writeup                    all pages, from the reference (learners: from student/)\n"
    "  ./run writeup --quality draft    a minute: small pictures of few samples\n"
    "  ./run writeup 3 adaptive         a part, and a figure\n"
    "  ./run writeup --from student     your own code; --from hit_bvh=student a mixture\n\n"
    "If it is stopped, the same command continues where it was. Exit codes: 0 all figures are "
    "made,\n"
    "1 a figure is missing (the page says why), 2 the arguments cannot be used.";

void describe(CLI::App& app, Options& options) {
  app.add_option("what", options.what,
                 "Parts (1 to 5, accuracy, needs, stability, bugs) and figures; default: all");
  app.add_flag("--list", options.list, "List every figure, whether it is up to date, and its time");
  app.add_option_function<std::string>(
         "--quality", [&](const std::string& word) { options.draft = word == "draft"; },
         "draft: a quarter of the width and height, a sixteenth of the samples")
      ->check(CLI::IsMember({"full", "draft"}))
      ->type_name("full|draft");
  app.add_option("--scenes", options.scenes, "Folder of the course's .dae files")
      ->check(CLI::ExistingDirectory);
  app.add_option("--submission", options.submissions,
                 "Somebody else's code, in the box: a folder, an archive, or a clone of CS184's "
                 "skeleton; of "
                 "several, up to four, pictures beside the reference's")
      ->allow_extra_args(false)
      ->check(CLI::ExistingPath);
  app.add_option("--out", options.out, "Folder for the pages");
  app.add_option("--text", options.texts, "Folder of the texts, part1.md and so on")
      ->check(CLI::ExistingDirectory);
  app.add_flag("--pdf", options.pdf, "Also one PDF per page, by Chromium");
  auto* const handbook =
      app.add_flag("--handbook", options.handbook,
                   "The pictures of the handbook, the README and docs/four_bugs");
  handbook->excludes("--quality")
      ->excludes("--scenes")
      ->excludes("--submission")
      ->excludes("--pdf");
  app.add_flag("--check", options.check, "With --handbook: compare, and write nothing")
      ->needs(handbook);
  app.add_flag("--retry", options.retry, "Try again what crashed or took too long");
  app.add_option("-t,--threads", options.threads, "Renders at a time; default: one per processor")
      ->check(CLI::Range(1, 1024));
  app.add_option("--from", options.from)->group("");
  app.add_option("--root", options.root)->group("");
  app.add_option("--by", options.by)->group("");
  app.add_option("--renderer", options.renderer)->group("");
  app.add_option("--accuracy", options.accuracy)->group("");
  app.add_option("--stability", options.stability)->group("");
  app.add_option("--measure", options.measure)->group("");
  app.add_option("--view", options.view)->group("");
  app.add_option("--view-worker", options.view_worker)->group("");
  app.add_option("--generate", options.generate)->group("");
  app.add_option("--mistakes", options.mistakes)->group("");
  app.add_option("--work", options.work)->group("");
  app.add_option("--boxed", options.boxed)->group("");
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
  Options options;
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  CLI::App app("Makes the write-up: every comparison figure of the course, on pages.",
               "./run writeup");
  app.footer(kFooter);
  describe(app, options);
  pt::parse(app, argc, argv);
  return options;
}

}  // namespace writeup
