// naming: hands in kept solutions with new random numbers, and tests the names that `grade` gives:
// for a mistake, only its own or that of a mistake with equal results; for a right solution, none;
// for a relative of a mistake (`vary` in mistakes.txt), only the name of that mistake.
#include "grader/mistakes/naming.h"

#include "grader/base/parallel.h"
#include "grader/base/sha256.h"
#include "grader/results/json.h"
#include "grader/service/judging/alone.h"
#include "grader/service/judging/ask_battery.h"
#include "grader/service/judging/name_mistakes.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/box.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/fixtures/task_folder.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace grader;
using namespace grader::tests;
namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> tasks;
  std::vector<std::string> kinds{"wrong", "relative", "right", "noisy"};
  int threads = 2;
  int each = 0;  // at most this many of a kind and task; 0: all
  bool verbose = false;
};

// At least this part of the mistakes is named.
constexpr double kMinNamed = 0.9;
constexpr std::uint64_t kSeedOfPromises = 1, kSeedOfDraws = 5;
constexpr std::chrono::seconds kPromiseTime{300};

// A solution and the findings on it.
struct Submission {
  const build::TaskConfig* task = nullptr;
  KeptSolution kept;
  mistakes::Evidence evidence;
};

// Guards have no name (cmake/edits.awk).
bool is_guard(const KeptSolution& kept) {
  return mistakes::described(kept.name, pt::read_file(kept.file)).sentence.empty();
}

// Picks a few solutions, always the same ones.
void keep_some(std::vector<KeptSolution>& all, int each) {
  if (each == 0 || all.size() <= static_cast<std::size_t>(each)) return;
  std::ranges::sort(all, {}, [](const KeptSolution& kept) { return base::sha256(kept.name); });
  all.resize(each);
}

std::vector<Submission> submissions_of(const build::Config& config, const build::TaskConfig& task,
                                       const Options& options) {
  std::vector<Submission> all;
  for (const std::string& kind : options.kinds) {
    std::vector<KeptSolution> kept = kept_solutions(config.root, task.slug, kind);
    if (kind == "wrong") std::erase_if(kept, is_guard);
    keep_some(kept, options.each);
    if (kind == "right") {
      kept.push_back({task.slug, kind, "reference", config.root + "/reference/" + task.file()});
    }
    for (KeptSolution& one : kept) all.push_back({&task, std::move(one), {}});
  }
  return all;
}

// The broken promises, without bonus promises.
std::set<std::string> broken_promises(const judging::Trial& trial, const std::string& report) {
  const std::vector<std::string> command{
      trial.task.graded,
      "--worker",
      trial.worker.path,
      "--report",
      report,
      "--seed",
      std::to_string(kSeedOfPromises),
      "--isolation",
      std::string(1, sandbox::letter(trial.request.isolation.tier)),
      "--no-shrinking"};
  fs::remove(report);
  process::run_command({command, sandbox::judges_environment(), {}, "", {}}, kPromiseTime);
  std::set<std::string> broken;
  const results::Results found = results::read_results(report);
  for (const results::PromiseResult& promise : found.tasks.at(0).promises) {
    if (!promise.bonus && !promise.held) broken.insert(promise.name);
  }
  return broken;
}

// Measures like the judge.
mistakes::Evidence measure(const build::Config& config, const build::Builder& builder,
                           const judging::GradeRequest& request, const Submission& submission) {
  const KeptSolution& kept = submission.kept;
  const std::string what = fmt::format("{}.{}.{}", kept.slug, kept.kind, kept.name);
  judging::Judged built;
  built.config = submission.task;
  built.object = builder.compile(*submission.task, pt::read_file(kept.file));
  if (!built.object.ok()) throw pt::Error(what + " is refused: " + built.object.error);
  const build::Built worker =
      judging::link_alone(config, builder, built, judging::Elsewhere::answers);
  if (!worker.ok()) throw pt::Error(what + " does not link: " + worker.error);
  const judging::Trial trial{*submission.task, worker, false, request, {}};
  const auto answers = judging::ask_battery(builder, trial, kSeedOfDraws, 1);
  if (!answers) throw pt::Error("the battery cannot be asked of " + what);
  mistakes::Evidence evidence{*answers,
                              broken_promises(trial, fmt::format("{}/{}.json", config.work, what))};
  fs::remove(worker.path);  // hundreds of workers fill a disk
  return evidence;
}

// One line with the numbers of a task.
struct Counts {
  int mistakes = 0, named = 0, passing = 0, relatives = 0, relatives_named = 0, right = 0,
      wrong_names = 0;
};

class Score {
 public:
  explicit Score(bool verbose) : verbose_(verbose) {}

  void add(const mistakes::KnownTask& known, const Submission& submission) {
    const KeptSolution& kept = submission.kept;
    Counts& counts = tasks_[kept.slug];
    mistakes::Evidence evidence = submission.evidence;
    if (kept.kind == "right" || kept.kind == "noisy") {
      ++counts.right;
      for (const mistakes::Fingerprint& each : known.mistakes) evidence.broken.insert(each.breaks);
    }
    if (evidence.broken.empty()) {
      ++counts.passing;
      return;
    }
    const auto found = mistakes::name_by_battery(known, evidence);
    const bool is_true = std::ranges::any_of(found, [&](const mistakes::Fingerprint* each) {
      return says_the_truth(known, kept, *each);
    });
    if (kept.kind == "wrong") ++counts.mistakes;
    if (kept.kind == "relative") ++counts.relatives;
    if (!found.empty() && !is_true) ++counts.wrong_names;
    if (is_true) ++(kept.kind == "wrong" ? counts.named : counts.relatives_named);
    if (verbose_ || (!found.empty() && !is_true)) tell(known, submission, found, is_true);
  }

  std::string table() const {
    std::string text =
        fmt::format("{:<18} {:>8} {:>6} {:>8} {:>10} {:>6} {:>6} {:>11}\n", "task", "mistakes",
                    "named", "passing", "relatives", "named", "right", "wrong names");
    for (const auto& [slug, c] : tasks_) {
      text +=
          fmt::format("{:<18} {:>8} {:>6} {:>8} {:>10} {:>6} {:>6} {:>11}\n", slug, c.mistakes,
                      c.named, c.passing, c.relatives, c.relatives_named, c.right, c.wrong_names);
    }
    const Counts all = sum();
    return text + fmt::format("{} of {} mistakes are named; of {} relatives {}; {} wrong names\n",
                              all.named, all.mistakes, all.relatives, all.relatives_named,
                              all.wrong_names);
  }

  Counts sum() const {
    Counts all;
    for (const auto& [slug, c] : tasks_) {
      all.mistakes += c.mistakes;
      all.named += c.named;
      all.relatives += c.relatives;
      all.relatives_named += c.relatives_named;
      all.wrong_names += c.wrong_names;
    }
    return all;
  }

 private:
  // A mistake's own sentence is true of it and of its relative, and so is the sentence of a mistake
  // with the same answers.
  static bool says_the_truth(const mistakes::KnownTask& known, const KeptSolution& kept,
                             const mistakes::Fingerprint& print) {
    if (kept.kind == "right" || kept.kind == "noisy") return false;
    return print.name == kept.name || print.sentence == sentence(known, kept.name);
  }

  static std::string sentence(const mistakes::KnownTask& known, const std::string& name) {
    const auto found = std::ranges::find(known.mistakes, name, &mistakes::Fingerprint::name);
    return found == known.mistakes.end() ? "" : found->sentence;
  }

  static void tell(const mistakes::KnownTask& known, const Submission& submission,
                   const std::vector<const mistakes::Fingerprint*>& found, bool is_true) {
    const KeptSolution& kept = submission.kept;
    std::string names;
    for (const mistakes::Fingerprint* each : found) names += " " + each->name;
    const auto own = std::ranges::find(known.mistakes, kept.name, &mistakes::Fingerprint::name);
    const bool agrees =
        own != known.mistakes.end() && mistakes::agree(submission.evidence.answers, own->answers);
    const bool as_right = mistakes::agree(submission.evidence.answers, known.right);
    fmt::print("{} {} {}: {}{}{}\n", kept.slug, kept.kind, kept.name,
               found.empty() ? "no name"
               : is_true     ? "named"
                             : "WRONG NAME",
               names,
               as_right ? ", answers as the reference does"
               : agrees ? ""
                        : ", other answers than are kept of it");
  }

  std::map<std::string, Counts> tasks_;
  bool verbose_;
};

int run(const Options& options) {
  build::Config config = build::load_config(build::default_config_path());
  config.work += "/naming";
  for (const std::string& task : options.tasks) judging::tasks_meant(config, task);
  judging::GradeRequest request;
  request.isolation = sandbox::probe_isolation(config.root, config.work);
  std::vector<Submission> all;
  std::map<std::string, mistakes::KnownTask> known;
  for (const build::TaskConfig& task : config.tasks) {
    if (!options.tasks.empty() && std::ranges::count(options.tasks, task.slug) == 0) continue;
    const std::string path = judging::known_path(task);
    known[task.slug] = mistakes::known_from_json(pt::read_file(path), path);
    for (Submission& one : submissions_of(config, task, options)) all.push_back(std::move(one));
  }
  const build::Builder builder(config, request.isolation.tier, request.compile_limit);
  std::atomic<int> ended = 0;
  base::for_each(all.size(), options.threads, [&](std::size_t i) {
    all[i].evidence = measure(config, builder, request, all[i]);
    std::fprintf(stderr, "\r%d of %zu solutions", ++ended, all.size());
  });
  std::fprintf(stderr, "\n");
  fs::remove_all(config.work);
  Score score(options.verbose);
  for (const Submission& one : all) score.add(known.at(one.kept.slug), one);
  fmt::print("{}", score.table());
  const Counts sum = score.sum();
  return sum.wrong_names == 0 && sum.named >= kMinNamed * sum.mistakes ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Tests what known mistakes, their relatives and right solutions are named"};
  app.add_option("task", options.tasks, "Tasks; default: all");
  app.add_option("--threads", options.threads, "At a time")->check(CLI::Range(1, 256));
  app.add_option("--kind", options.kinds, "Only these")
      ->check(CLI::IsMember({"wrong", "relative", "right", "noisy"}));
  app.add_option("--each", options.each, "Of each task and kind, only so many");
  app.add_flag("--verbose", options.verbose, "Say what each solution is named");
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
