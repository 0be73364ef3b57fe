// stability.<slug>: where the methods of one task fail, measured on a worker: its curves
// (grader/check/language/curve.h), or with --search the worst inputs found within a given time
// (grader/check/language/bad_inputs.h). `./run stability` runs it for each line of a chart.
#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/curve.h"
#include "grader/service/wire/ask_worker.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace {

namespace check = grader::check;
using nlohmann::json;

// NaN becomes null.
json to_json(const check::MeasuredPlace& at) {
  return {{"place", at.place},     {"error", at.error},   {"noise", at.noise}, {"cases", at.cases},
          {"without", at.without}, {"reason", at.reason}, {"ended", at.ended}};
}

// The corners from left to right: [place, limit], at the curve's places and the promise's ends.
json to_json(const check::Promised& promised, const std::vector<double>& places) {
  const auto [least, most] = std::minmax(promised.first, promised.last);
  std::vector<double> at{least, most};
  for (const double place : places) {
    if (place > least && place < most) at.push_back(place);
  }
  std::ranges::sort(at);
  json corners = json::array();
  for (const double place : at) corners.push_back({place, promised.limit(place)});
  return {{"bonus", promised.bonus}, {"corners", corners}};
}

// The number that is drawn of the cases at a place.
const char* name_of(check::Statistic statistic) {
  constexpr const char* kNames[] = {"largest", "mean", "median", "mean"};
  return kNames[static_cast<int>(statistic)];
}

json to_json(const check::NamedCurve& named, const std::vector<check::MeasuredPlace>& measured) {
  const check::Curve& curve = named.curve;
  json all{{"name", named.name},
           {"title", curve.title},
           {"input", curve.input},
           {"error", curve.error},
           {"source", curve.source},
           {"methods", json::array()},
           {"places", json::array()},
           {"promised", json::array()},
           {"statistic", name_of(curve.statistic)}};
  for (const check::Promised& promised : curve.promised) {
    all["promised"].push_back(to_json(promised, curve.places));
  }
  for (const check::Method& method : curve.methods) {
    all["methods"].push_back(
        {{"file", method.file}, {"title", method.title}, {"single", method.single}});
  }
  for (const check::MeasuredPlace& at : measured) {
    all["places"].push_back(to_json(at));
    if (curve.theory) all["places"].back()["theory"] = curve.theory(at.place);
  }
  return all;
}

// Measures the curves of this program's task, or only the named curve, and writes them as JSON: a
// list of objects with the texts of the chart, the places, the results there, and the seconds that
// they took. An error that is not a number is null. `begin` is called before each place. Throws pt::Error if the curve does not
// exist or the file cannot be written.
void write_curves(const std::string& path, const std::string& only,
                  const grader::check::CurveSettings& settings,
                  const std::function<void()>& begin) {
  json all = json::array();
  for (const check::NamedCurve& named : check::curves()) {
    if (!only.empty() && named.name != only) continue;
    const auto start = std::chrono::steady_clock::now();
    all.push_back(to_json(named, check::measure(named.curve, settings, begin)));
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    all.back()["seconds"] = passed.count();
  }
  if (!only.empty() && all.empty()) throw pt::Error("no curve has the name '" + only + "'");
  pt::write_file(path, all.dump(1) + "\n");
}

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
  write_curves(options.curves, options.curve,
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
