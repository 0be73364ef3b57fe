#include "grader/judge/findings.h"

#include "grader/base/files.h"
#include "grader/base/printable.h"
#include "grader/base/sha256.h"
#include "grader/judge/cache.h"
#include "grader/judge/object_file.h"
#include "grader/process/run_command.h"
#include "pt/error.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include <cxxabi.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

namespace grader::judge {

namespace {

using nlohmann::json;

// Far beyond what the program allows itself: a fault of ours if it is reached.
constexpr std::chrono::seconds kProgramTime{1500};

results::FailureReport parse_failure(const json& failure, bool integrated) {
  results::FailureReport report;
  failure.at("input").get_to(report.input);
  failure.at("what").get_to(report.what);
  failure.at("got").get_to(report.got);
  failure.at("expected").get_to(report.expected);
  failure.at("off_by").get_to(report.off_by);
  failure.at("cause").get_to(report.cause);
  failure.at("cases_before").get_to(report.cases_before);
  failure.at("seed").get_to(report.seed);
  report.integrated = integrated;
  return report;
}

// "pt::(anonymous namespace)::count" is count, as is "pt::hit_bvh(...)::count". Not known: "".
std::string variable_at(const Built& worker, std::uint64_t place) {
  const std::string symbol = state_at(base::read_file(worker.path), place);
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  const std::string name = text ? text.get() : symbol;
  const std::size_t last = name.rfind("::");
  return base::printable(last == name.npos ? name : name.substr(last + 2), 100);
}

// In the integrated worker a variable may be another task's.
std::string kept_variable(std::uint64_t kept, const Trial& trial) {
  if (kept == 0 || trial.integrated) return "";
  const std::string name = variable_at(trial.worker, kept - 1);
  return name.empty() ? "a variable" : "the variable '" + name + "'";
}

Findings parse(const std::string& text, const Trial& trial) {
  const bool integrated = trial.integrated;
  const json report = json::parse(text);
  Findings findings;
  report.at("todo").get_to(findings.todo);
  report.at("printed").get_to(findings.printed);
  findings.kept = kept_variable(report.at("kept").get<std::uint64_t>(), trial);
  for (const json& promise : report.at("promises")) {
    results::PromiseResult result;
    promise.at("name").get_to(result.name);
    promise.at("held").get_to(result.held);
    promise.at("seconds").get_to(result.seconds);
    result.bonus = result.name.ends_with("_bonus");
    for (const json& failure : promise.at("failures")) {
      result.failures.push_back(parse_failure(failure, integrated));
    }
    findings.promises.push_back(result);
  }
  return findings;
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
  if (!trial.promises.empty()) {
    std::string filter;
    for (const std::string& name : trial.promises) filter += "*." + name + ":";
    words.push_back("--promises=" + filter);
  }
  return words;
}

bool timed_out(const Findings& findings) {
  for (const results::PromiseResult& promise : findings.promises) {
    for (const results::FailureReport& failure : promise.failures) {
      if (failure.cause == "timeout") return true;
    }
  }
  return false;
}

}  // namespace

Findings try_worker(const Builder& builder, const Trial& trial) {
  std::string key = base::stamp(trial.task.graded) + trial.worker.key;
  for (const std::string& word : command(trial, "")) key += '\0' + word;
  const std::string path = builder.cache() + "/" + base::sha256(key) + ".json";
  if (std::filesystem::exists(path)) {
    mark_used(path);
    try {
      return parse(base::read_file(path), trial);
    } catch (const json::exception&) {
      std::filesystem::remove(path);  // damaged: it is found out again
    }
  }

  const std::string report = base::temporary_name(path);
  const process::CommandResult result = process::run_command(
      {command(trial, report), {"PATH=/usr/bin", "LANG=C.UTF-8"}, {}, "", {}}, kProgramTime);
  const bool finished =
      !result.timed_out && WIFEXITED(result.status) && WEXITSTATUS(result.status) <= 1;
  if (!finished || !std::filesystem::exists(report)) {
    std::filesystem::remove(report);
    throw pt::Error(
        fmt::format("{} could not be judged: {}", trial.task.slug, process::fault_of(result)));
  }
  Findings findings = parse(base::read_file(report), trial);
  if (findings.promises.empty()) {
    throw pt::Error("no property of " + trial.task.slug + " was run: nothing is judged");
  }
  // The time that a call takes depends on what else the machine does: that is asked again.
  if (timed_out(findings)) {
    std::filesystem::remove(report);
  } else {
    std::filesystem::rename(report, path);
  }
  return findings;
}

}  // namespace grader::judge
