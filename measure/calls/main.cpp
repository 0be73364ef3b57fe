// measure [TASK ...]: the time of each implementation of a task against its error or noise. Each
// runs in the box, none in this process. The exit status is 1 if somebody's own code has no numbers, or
// is wrong.
#include "grader/service/intake/taken_in.h"
#include "grader/service/process/process_time.h"
#include "grader/service/process/spawn.h"
#include "grader/service/sandbox/probe.h"
#include "measure/calls/measuring.h"
#include "measure/calls/print.h"
#include "measure/charts/labels.h"
#include "measure/renders/worker_config.h"
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/render/progress.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <deque>
#include <optional>

#include <fmt/format.h>
#include <sched.h>

namespace measure::calls {
namespace {

const char* const kConfig = "measure.json";
constexpr double kSecondsForOne = 40, kSecondsForEach = 20;

// On one processor, workers that take turns are disturbed alike; with two, one may be busier.
void stay_on_this_processor() {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<std::size_t>(sched_getcpu()), &set);
  sched_setaffinity(0, sizeof set, &set);  // if this is forbidden, measure nevertheless
}

Materials materials_for(const grader::build::Config& config, const Options& options) {
  if (!config.no_reference.empty()) {
    throw pt::Error("there is nothing to compare with: " + config.no_reference);
  }
  std::optional<grader::sandbox::Tier> forced;
  if (!options.isolation.empty()) forced = grader::sandbox::tier_of(options.isolation);
  const auto isolation = grader::sandbox::probe_isolation(config.root, config.work, forced);
  return {config, fast_objects(kConfig), isolation.tier};
}

std::vector<Contest> compiled(const Materials& materials, const Options& options) {
  pt::Progress progress;
  std::vector<Contest> contests =
      find_contests(materials, options, [&](double part) { progress.show(part); });
  progress.clear();
  return contests;
}

int run(int argc, const char* const* argv) {
  const grader::build::Config config = worker_config(kConfig);
  Options options = parse_options(argc, argv, config.root);
  std::deque<grader::intake::TakenIn> taken;
  const std::vector<std::string> labels = labels_of(options.submissions);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    taken.emplace_back(config, options.submissions[i]);
    options.own.push_back({"", taken.back().folder(), labels[i]});
  }
  const Materials materials = materials_for(config, options);
  if (!options.out.empty()) std::filesystem::create_directories(options.out);
  const std::vector<Contest> contests = compiled(materials, options);
  const auto n = static_cast<double>(contests.size());
  const double seconds = options.seconds > 0    ? options.seconds / n
                         : contests.size() == 1 ? kSecondsForOne
                                                : kSecondsForEach;
  stay_on_this_processor();
  pt::Progress progress;
  std::vector<Results> all;
  bool good = true;
  for (const Contest& contest : contests) {
    const auto done = static_cast<double>(all.size());
    all.push_back(measure_contest(contest, materials.tier, seconds, [&](double part) {
      progress.show((done + std::min(part, 1.0)) / n);
    }));
    progress.clear();
    fmt::print("{}", to_text(all.back()));
    pt::flush_standard_output();
    good = good && !own_code_fails(all.back());
    if (!options.out.empty()) draw_charts(all.back(), options.out);
  }
  if (!options.out.empty()) pt::write_file(options.out / "measure.csv", to_csv(all));
  return good ? 0 : 1;
}

}  // namespace
}  // namespace measure::calls

int main(int argc, char** argv) {
  grader::process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  return pt::run_program([&] { return measure::calls::run(argc, argv); });
}
