// stability [TASK | PART] ... [--submission DIR]: where methods fail, as curves. Measures each task's
// curves (grader/tasks/<task>/curves.cpp) with the reference, a submission, and the solutions that are
// kept in the tree, all in boxes. The exit status is 1 if the submission cannot be measured, is wrong,
// or ends its program.
#include "grader/base/sha256.h"
#include "grader/service/intake/taken_in.h"
#include "grader/service/process/process_time.h"
#include "grader/service/sandbox/probe.h"
#include "measure/failure/lines.h"
#include "measure/failure/print.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/render/progress.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace measure::failure {
namespace {

namespace fs = std::filesystem;
namespace build = grader::build;
namespace judging = grader::judging;
using nlohmann::json;

constexpr std::size_t kShown = 2;

std::string text_of(const std::string& slug, const json& search) {
  std::string text =
      fmt::format("{}: {}\n  {}\n  {} inputs in {:.0f} seconds, all runs together\n", slug,
                  search.at("title").get<std::string>(), search.at("measure").get<std::string>(),
                  search.at("tried").get<long long>(), search.at("seconds").get<double>());
  const json& worst = search.at("worst");
  for (std::size_t i = 0; i < std::min(kShown, worst.size()); ++i) {
    text += worst[i].at("broken") ? "  broken: " + worst[i].at("reason").get<std::string>() + "\n"
                                  : fmt::format("  {:.3g}\n", worst[i].at("badness").get<double>());
    std::string input = worst[i].at("input");
    for (std::size_t at = 0; (at = input.find('\n', at)) != input.npos; at += 5) {
      input.replace(at, 1, "\n    ");
    }
    text += "    " + input + "\n";
  }
  return text;
}

// Returns whether the task has searches.
bool has_searches(const build::Config& config, const build::TaskConfig& task) {
  return fs::exists(config.root + "/grader/tasks/" + task.slug + "/searches.cpp");
}

struct Options {
  std::vector<std::string> what;
  std::string out;
  bool no_methods = false, no_variants = false, keys = false, search = false;
  double minutes = 1;
  std::string named;  // the submission as it was named; the request has the folder of its files
  Request request;
};

// Searches for the inputs on which a task is furthest from an exact oracle, and prints the worst
// ones. The worst inputs are kept in `folder`, one file per task and submission. Returns whether
// the task could be searched.
bool search_all(const build::Config& config, const build::TaskConfig& task, const Options& options,
                const std::string& folder) {
  const Request& request = options.request;
  fs::create_directories(folder);
  CurveLine line;
  std::string name = task.slug;
  if (!request.submission.empty()) {
    line.kind = CurveLine::Kind::submission;
    name += "." + grader::base::sha256(fs::absolute(options.named).string()).substr(0, 8);
  }
  const Answered found =
      search_task(config, task, request, {options.minutes, folder + "/" + name + ".json"}, line);
  if (!found.unusable.empty()) {
    fmt::print("{} is not searched: {}\n", task.slug, found.unusable);
    return false;
  }
  for (const json& search : found.answer) fmt::print("{}\n", text_of(task.slug, search));
  return true;
}

bool has_curves(const build::Config& config, const build::TaskConfig& task) {
  return fs::exists(config.root + "/grader/tasks/" + task.slug + "/curves.cpp");
}

std::vector<build::TaskConfig> tasks_of(const build::Config& config, const Options& options) {
  std::set<std::string> asked;
  for (const std::string& word : options.what) {
    for (const std::string& slug : judging::tasks_meant(config, word)) asked.insert(slug);
  }
  std::vector<build::TaskConfig> tasks;
  for (const build::TaskConfig& task : config.tasks) {
    const bool meant = asked.empty() || asked.contains(task.slug);
    if (meant && has_curves(config, task)) tasks.push_back(task);
  }
  if (tasks.empty()) throw pt::Error(options.what[0] + " has no curves yet");
  return tasks;
}

// Prints a hash of everything that the charts of each task depend on, for the write-up.
int print_keys(const build::Config& config, const std::vector<build::TaskConfig>& tasks,
               const Request& request) {
  for (const build::TaskConfig& task : tasks) {
    fmt::print("{} {}\n", task.slug, charts_hash(config, task, request));
  }
  return 0;
}

// The worst inputs so far are kept next to the files of `grade`.
int search(const build::Config& config, const std::vector<build::TaskConfig>& tasks,
           const Options& options) {
  bool all = true, any = false;
  for (const build::TaskConfig& task : tasks) {
    if (!has_searches(config, task)) continue;
    any = true;
    const std::string folder = config.work + "/searches";
    all = search_all(config, task, options, folder) && all;
    std::fflush(stdout);
  }
  if (!any) throw pt::Error(tasks[0].slug + " has no search: its oracles are statistical");
  return all ? 0 : 1;
}

double cpu_seconds() {
  return std::chrono::duration<double>(grader::process::time_of_tree(getpid()).running).count();
}

int run(Options options) {
  const build::Config config = build::load_config(build::default_config_path());
  const std::vector<build::TaskConfig> tasks = tasks_of(config, options);
  Request& request = options.request;
  request.methods = !options.no_methods;
  request.variants = !options.no_variants && request.methods;
  std::optional<grader::intake::TakenIn> taken;
  if (!request.submission.empty()) {
    taken.emplace(config, request.submission);
    options.named = request.submission;
    request.submission = taken->folder();
  }
  if (options.keys) return print_keys(config, tasks, request);
  request.judge.isolation = grader::sandbox::probe_isolation(config.root, config.work);
  if (options.search) return search(config, tasks, options);
  if (!options.out.empty()) fs::create_directories(options.out);
  bool good = true;
  std::vector<Charts> all;
  for (const build::TaskConfig& task : tasks) {
    pt::TimedProgress progress(task.slug + ": building, and a look at some of the places");
    all.push_back(
        measure_task(config, task, request, [&](double seconds) { progress.expect(seconds); }));
    progress.clear();
    const Charts& charts = all.back();
    fmt::print("{}", to_text(charts));
    std::fflush(stdout);
    if (!options.out.empty()) write_charts(charts, options.out);
    good = good && !fails(charts);
  }
  if (!options.out.empty()) {
    pt::write_file(fs::path(options.out) / "stability.json", to_json(all, cpu_seconds()));
    fmt::print("charts and numbers: {}\n", options.out);
  }
  return good ? 0 : 1;
}

}  // namespace
}  // namespace measure::failure

int main(int argc, char** argv) {
  using measure::failure::Options;
  Options options;
  CLI::App app{"Shows where methods fail: the error of each task by how hard its input is",
               "./run stability"};
  app.footer(
      "Examples:\n  ./run stability --list\n  ./run stability hit_sphere\n  ./run stability 1 "
      "--from student --out curves\n"
      "  ./run stability hit_sphere --submission FOLDER\n\nExit codes: 0 measured, 1 the "
      "submission "
      "cannot be measured, breaks a promise, crashes, or gives no answer\nin time, 2 the arguments "
      "cannot be used.");
  app.add_option("what", options.what, "tasks (hit_sphere), parts (1) or exercises (1.3)");
  app.add_option("--submission", options.request.submission,
                 "a folder, an archive, or a clone of CS184's skeleton: its lines are drawn too")
      ->check(CLI::ExistingPath);
  app.add_option("--out", options.out, "a folder for charts and their numbers; default: none");
  app.add_flag("--no-methods", options.no_methods,
               "only the reference and your own code, and no other method");
  app.add_flag("--no-variants", options.no_variants,
               "only the methods that a curve is about, not every right solution");
  app.add_option("--effort", options.request.effort, "times the usual number of random cases")
      ->check(CLI::Range(0.001, 1000.0))
      ->take_last()
      ->capture_default_str();
  app.add_flag("--coarse", options.request.coarse, "only every third place");
  app.add_flag("--search", options.search,
               "search for inputs with large errors instead; it goes on where the last one ended");
  app.add_option("--minutes", options.minutes, "of a search, per task")
      ->check(CLI::Range(0.01, 10000.0))
      ->capture_default_str();
  app.add_flag("--keys", options.keys)->group("");
  app.add_option("--seed", options.request.judge.seed, "of the random cases")
      ->capture_default_str();
  app.add_option("-t,--threads", options.request.judge.threads, "how many lines at the same time")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  return pt::run_command_line(app, argc, argv, [&] { return measure::failure::run(options); });
}
