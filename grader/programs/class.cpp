#include "grader/programs/class.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/process/run_command.h"
#include "grader/report/csv.h"
#include "grader/results/presentable.h"
#include "grader/results/read_json.h"
#include "grader/results/summary.h"
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include <fmt/format.h>
#include <sys/wait.h>

namespace grader::programs {

namespace {

namespace fs = std::filesystem;

// Far beyond the slowest submission there is.
constexpr std::chrono::hours kMaxTime{2};

// Stands for all that the reports depend on.
std::string key_of(const judge::Config& config, const ClassRequest& request,
                   const std::string& submission) {
  std::string key = base::stamp(request.grade) + base::stamp(config.root + "/grader/points.json") +
                    base::stamp(config.root + "/scenes/recipes.json");
  const std::string golden = config.root + "/golden";
  if (fs::exists(golden)) key += base::stamp(golden);
  for (const std::string& word : request.words) key += word + '\0';
  key += std::to_string(request.seed);
  for (const judge::TaskConfig& task : config.tasks) {
    const base::Submitted file =
        base::read_submitted(base::submission_root(submission), task.part, task.slug);
    key += fmt::format("{} {} {}\n", file.present, file.rejected, base::sha256(file.text));
    if (!task.graded.empty()) key += base::stamp(task.graded);
  }
  return base::sha256(key);
}

bool has_reports(const std::string& path, const std::string& key) {
  for (const char* ending : {".json", ".html", ".key"}) {
    if (!fs::exists(path + ending)) return false;
  }
  return base::read_file(path + ".key") == key;
}

// Returns why it could not be judged; empty if it was.
std::string run_grade(const ClassRequest& request, const std::string& submission,
                      const std::string& path) {
  std::vector<std::string> command{request.grade, "--submission=" + submission,
                                   "--json=" + path + ".json", "--html=" + path + ".html",
                                   "--seed=" + std::to_string(request.seed)};
  command.insert(command.end(), request.words.begin(), request.words.end());
  const process::CommandResult run =
      process::run_command({command, {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"}, {}, "", {}}, kMaxTime);
  if (!run.timed_out && WIFEXITED(run.status) && WEXITSTATUS(run.status) <= 1) return "";
  return process::fault_of(run);
}

const results::TaskResult* find_task(const results::Results& results, const std::string& slug) {
  for (const results::TaskResult& task : results.tasks) {
    if (task.slug == slug) return &task;
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> submissions_of(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (entry.is_directory() && !entry.is_symlink() && name[0] != '.') names.push_back(name);
  }
  if (names.empty()) {
    throw pt::Error(folder + " has no folders in it: there must be one per submission");
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::uint64_t seed_for(const std::string& out, std::optional<std::uint64_t> asked) {
  const std::string path = out + "/seed";
  std::uint64_t seed = 0;
  if (asked) {
    seed = *asked;
  } else if (std::ifstream(path) >> seed) {
    return seed;
  } else {
    seed = std::random_device{}();
  }
  pt::write_file(path, std::to_string(seed) + "\n");
  return seed;
}

Graded grade_one(const judge::Config& config, const ClassRequest& request,
                 const std::string& name) {
  Graded graded;
  graded.name = name;
  const std::string submission = request.folder + "/" + name;
  const std::string path = request.out + "/" + name;
  try {
    const std::string key = key_of(config, request, submission);
    graded.again = has_reports(path, key);
    if (!graded.again) {
      fs::remove(path + ".key");  // the run may end before its reports are whole
      graded.problem = run_grade(request, submission, path);
    }
    if (!graded.problem.empty()) return graded;
    graded.results = results::read_results(path + ".json");
    if (!graded.results.complete) {
      graded.problem = "the run was stopped before it ended";
    } else if (!graded.again) {
      pt::write_file(path + ".key", key);
    }
  } catch (const std::exception& error) {
    graded.problem = pt::sentence_of(error);
  }
  return graded;
}

std::string class_table(const judge::Config& config, const std::vector<Graded>& all) {
  std::string text = std::string(report::kByteOrderMark) +
                     "submission,tasks_passed,points,max_points,bonus_points";
  for (const judge::TaskConfig& task : config.tasks)
    text += fmt::format(",{0},{0}_points", task.slug);
  text += ",problem\r\n";
  for (const Graded& each : all) {
    const bool judged = each.problem.empty();
    const results::Totals sums = results::totals(each.results.tasks);
    text += report::csv_field(results::one_line(each.name));
    text += judged ? fmt::format(",{},{},{},{}", sums.passed, sums.points, sums.max_points,
                                 sums.bonus_points)
                   : ",,,,";
    for (const judge::TaskConfig& task : config.tasks) {
      const results::TaskResult* found = judged ? find_task(each.results, task.slug) : nullptr;
      text += found == nullptr ? ",,"
                               : fmt::format(",{},{}", results::words(found->state),
                                             found->points + found->bonus_points);
    }
    text += "," + report::csv_field(results::one_line(each.problem)) + "\r\n";
  }
  return text;
}

}  // namespace grader::programs
