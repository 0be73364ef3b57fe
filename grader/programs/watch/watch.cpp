// watch: judges each task when its file is saved, by running grade, and shows what it found. Exit
// status 0 when the learner quits, 2 if there is no terminal or nothing to watch.
#include "grader/judge/config.h"
#include "grader/programs/watch/fit.h"
#include "grader/programs/watch/raw_terminal.h"
#include "grader/programs/watch/session.h"
#include "grader/report/terminal.h"
#include "pt/command_line.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  using namespace grader;
  std::signal(SIGPIPE, SIG_IGN);
  programs::WatchOptions options;
  options.submission = "student";
  CLI::App app{"Checks each task when its file is saved", "./run watch"};
  app.add_option("--submission", options.submission, "a folder with the tree of student/")
      ->check(CLI::ExistingDirectory);
  app.add_option("--config", options.config,
                 "what CMake wrote (grade.json); the programs grade and hint are next to it");
  return pt::run_command_line(app, argc, argv, [&] {
    if (options.config.empty()) options.config = judge::default_config_path();
    options.programs = std::filesystem::absolute(options.config).parent_path();
    options.style.width = std::clamp(programs::screen_size().columns, 40, 100);
    options.style.color = report::terminal_has_color();
    const judge::Config config = judge::load_config(options.config);
    programs::RawTerminal terminal;
    return programs::WatchSession(config, options).run(terminal);
  });
}
