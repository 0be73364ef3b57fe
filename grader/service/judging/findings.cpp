#include "grader/service/judging/findings.h"

#include "grader/base/files.h"
#include "grader/base/printable.h"
#include "grader/base/sha256.h"
#include "grader/results/json.h"
#include "grader/service/build/cache.h"
#include "grader/service/process/cause_of_end.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/box.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include <fmt/format.h>
#include <sys/wait.h>

namespace grader::judging {

namespace {

// Throws pt::Error if the file is damaged.
results::TaskResult read_task(const std::string& path) {
  const results::Results results = results::read_results(path);
  if (results.tasks.empty()) throw pt::Error(path + " holds no task");
  return results.tasks[0];
}

std::vector<std::string> command(const Trial& trial, const std::string& report) {
  std::vector<std::string> words{trial.task.graded,
                                 "--worker",
                                 trial.worker.path,
                                 "--report",
                                 report,
                                 "--seed",
                                 std::to_string(trial.request.seed),
                                 "--call-limit",
                                 std::to_string(trial.request.call_limit),
                                 "--isolation",
                                 std::string(1, sandbox::letter(trial.request.isolation.tier))};
  if (trial.integrated) words.push_back("--integrated");
  if (trial.request.dialect) words.push_back("--no-wild");
  if (trial.request.dialect && trial.request.dialect->single_precision)
    words.push_back("--single-precision");
  if (!trial.promises.empty()) {
    std::string filter;
    for (const std::string& name : trial.promises) filter += "*." + name + ":";
    words.push_back("--promises=" + filter);
  }
  return words;
}

bool timed_out(const results::TaskResult& task) {
  return std::ranges::any_of(task.promises, [](const results::PromiseResult& promise) {
    return std::ranges::count(promise.failures, results::Cause::timeout, &results::Failure::cause) >
           0;
  });
}

bool was_killed(const results::TaskResult& task) {
  return std::ranges::any_of(task.promises, [](const results::PromiseResult& promise) {
    return std::ranges::any_of(promise.failures, process::was_killed, &results::Failure::got);
  });
}

// The judge's own time for the answers of one task, in limits of a call; the calls themselves may
// take 15. Right work takes seconds.
constexpr int kMostTime = 150;

results::TaskResult run_program(const Trial& trial, const std::string& report) {
  const process::CommandResult result = process::run_command(
      {command(trial, report), sandbox::judges_environment(), {}, "", {}},
      kMostTime * std::chrono::milliseconds(trial.request.call_limit), trial.stop);
  const bool finished =
      !result.timed_out && WIFEXITED(result.status) && WEXITSTATUS(result.status) <= 1;
  if (result.timed_out || WIFSIGNALED(result.status)) {
    std::filesystem::remove(report);
    results::TaskResult none;
    std::tie(none.state, none.reason) = ended_by_answers(result);
    return none;
  }
  if (!finished || !std::filesystem::exists(report)) {
    std::filesystem::remove(report);
    throw pt::Error(
        fmt::format("{} could not be judged: {}", trial.task.slug, process::fault_of(result)));
  }
  results::TaskResult found = read_task(report);
  if (found.promises.empty()) {
    throw pt::Error("no property of " + trial.task.slug + " was run: nothing is judged");
  }
  return found;
}

}  // namespace

std::pair<results::State, std::string> ended_by_answers(const process::CommandResult& ended) {
  constexpr const char* kSentence = "the judge could not work with its answers: its program {}";
  if (ended.timed_out) return {results::State::timeout, fmt::format(kSentence, "took too long")};
  return {results::State::crash,
          fmt::format(kSentence, "ended with " + process::describe_status(ended.status))};
}

results::TaskResult try_worker(const build::Builder& builder, const Trial& trial) {
  std::string key = build::content_stamp(trial.task.graded, builder.cache()) + trial.worker.key;
  for (const std::string& word : command(trial, "")) key += '\0' + word;
  const std::string path = builder.cache() + "/" + base::sha256(key) + ".json";
  if (std::filesystem::exists(path)) {
    build::mark_used(path);
    return read_task(path);
  }

  const std::string report = pt::temporary_name(path);
  results::TaskResult found = run_program(trial, report);
  const bool ended = found.promises.empty() && found.state == results::State::crash;
  if (ended || was_killed(found)) found = run_program(trial, report);
  // Time and memory depend on the machine's load, so the next request tries again.
  if (timed_out(found) || was_killed(found) || found.promises.empty()) {
    std::filesystem::remove(report);
  } else {
    std::filesystem::rename(report, path);
  }
  return found;
}

}  // namespace grader::judging
