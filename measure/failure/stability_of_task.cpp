// stability.<slug>: where the methods of one task fail, measured on a worker: its curves
// (grader/check/language/curve.h), or with --search the worst inputs found within a given time
// (grader/check/language/bad_inputs.h). `./run stability` runs it for each line of a chart.
#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/curve.h"
#include "grader/service/wire/ask_worker.h"
#include "measure/failure/write_curves.h"
#include "pt/error.h"

#include <CLI/CLI.hpp>

namespace {

struct Options {
  grader::wire::AskOptions ask;
  std::string curves;   // the file for the curves
  std::string curve;    // the only curve to measure; empty: all
  double effort = 1;    // factor of the usual number of cases
  bool coarse = false;  // every third place
  std::string search;   // the file for the worst inputs
  double seconds = 60;  // for the search, or the maximum per curve
};

int run_curves(const Options& options) {
  grader::wire::SessionSettings session = options.ask.session;
  session.total_limit = std::chrono::minutes(1);
  measure::failure::write_curves(
      options.curves, options.curve,
      {options.ask.seed, options.effort, options.coarse, options.seconds},
      [&] { grader::wire::open_session(session); });
  return 0;
}

int run_search(const Options& options) {
  grader::wire::SessionSettings session = options.ask.session;
  session.total_limit = std::chrono::hours(1);
  session.max_failures = 1000000000;
  grader::check::run_searches({options.ask.seed, options.seconds, options.search,
                               [&] { grader::wire::open_session(session); }});
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.ask.session.task = grader::check::curves().front().task;
  options.ask.session.max_timeouts = 1;  // one hanging call is enough for a place
  CLI::App app{"Measures where the methods of one task fail, on a worker"};
  app.add_option("--curves", options.curves, "where to write the curves, as JSON");
  app.add_option("--curve", options.curve, "only the curve of this name");
  app.add_option("--effort", options.effort, "of the curves: times the usual number of cases")
      ->check(CLI::PositiveNumber);
  app.add_flag("--coarse", options.coarse, "of the curves: every third place only");
  app.add_option("--search", options.search,
                 "search for bad inputs instead: where to keep the worst");
  app.add_option("--seconds", options.seconds, "of the search, or at most of each curve")
      ->check(CLI::PositiveNumber);
  return grader::wire::run_asking(app, argc, argv, options.ask, [&] {
    if (!options.curves.empty()) return run_curves(options);
    if (!options.search.empty()) return run_search(options);
    throw pt::Error("say --curves FILE or --search FILE");
  });
}
