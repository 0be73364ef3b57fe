// search.<slug>: searches for the inputs on which the reference of one task is furthest from an
// exact answer (grader/check/language/bad_inputs.h), with the reference in this process: it needs
// no box, and calls to a worker would cost most of its time. `./run stability TASK --search` runs
// it.
#include "grader/check/language/bad_inputs.h"
#include "pt/command_line.h"

int main(int argc, char** argv) {
  grader::check::SearchSettings settings;
  settings.begin = [] {};
  CLI::App app{"Searches for the worst inputs of one task's reference, in this process"};
  app.add_option("--search", settings.file, "where to keep the worst")->required();
  app.add_option("--seconds", settings.seconds, "of the search")->check(CLI::PositiveNumber);
  app.add_option("--seed", settings.seed, "of what is drawn");
  return pt::run_command_line(app, argc, argv, [&] {
    grader::check::run_searches(settings);
    return 0;
  });
}
