// watch: judges each task when its file is saved, by running grade, and shows what it found. Exit
// status 0 when the learner quits, 2 if there is no terminal or nothing to watch.
#include "grader/report/terminal.h"
#include "grader/service/build/config.h"
#include "grader/watch/fit.h"
#include "grader/watch/raw_terminal.h"
#include "grader/watch/session.h"
#include "pt/command_line.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  using namespace grader;
  std::signal(SIGPIPE, SIG_IGN);
  watch::WatchOptions options;
  options.submission = "student";
  CLI::App app{"Checks each task when its file is saved", "./run watch"};
  app.add_option("--submission", options.submission,
                 "a folder with the tree of student/, or a clone of CS184's skeleton")
      ->check(CLI::ExistingDirectory);
  app.add_option("--config", options.config,
                 "what CMake wrote (grade.json); the programs grade and hint are next to it");
  return pt::run_command_line(app, argc, argv, [&] {
    if (options.config.empty()) options.config = build::default_config_path();
    options.programs = std::filesystem::absolute(options.config).parent_path();
    options.style.width = std::clamp(watch::screen_size().columns, 40, 100);
    options.style.input_last = true;
    options.style.color = report::terminal_has_color();
    const build::Config config = build::load_config(options.config);
    watch::RawTerminal terminal;
    return watch::WatchSession(config, options).run(terminal);
  });
}
