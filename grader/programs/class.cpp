#include "grader/programs/class.h"

#include "grader/base/files.h"
#include "grader/base/printable.h"
#include "grader/base/sha256.h"
#include "grader/intake/unpack.h"
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
#include <thread>

#include <fmt/format.h>
#include <sys/wait.h>

namespace grader::programs {

namespace {

namespace fs = std::filesystem;

// Far beyond the slowest submission there is.
constexpr std::chrono::hours kMaxTime{2};
constexpr std::chrono::minutes kMaxUnpacking{5};
constexpr std::size_t kMaxReason = 300;

// Stands for all that the reports depend on.
std::string key_of(const judge::Config& config, const ClassRequest& request,
                   const std::string& submission) {
  std::string key = base::stamp(request.grade) + base::stamp(config.root + "/grader/points.json") +
                    base::stamp(config.root + "/scenes/recipes.json");
  const std::string golden = config.root + "/golden";
  if (fs::exists(golden)) key += base::stamp(golden);
  for (const std::string& word : request.words) key += word + '\0';
  key += std::to_string(request.seed);
  const std::string root = base::submission_root(submission);
  for (const judge::TaskConfig& task : config.tasks) {
    const base::Submitted file = base::read_submitted(root, task.part, task.slug);
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

// Verdicts do not depend on it.
int threads_each(const ClassRequest& request) {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / request.jobs);
}

// Why none of the tasks can be judged: there is not one file of them. Empty if there is.
std::string why_nothing(const judge::Config& config, const std::string& submission) {
  const std::string root = base::submission_root(submission);
  for (const judge::TaskConfig& task : config.tasks) {
    if (base::read_submitted(root, task.part, task.slug).present) return "";
  }
  return fmt::format("it holds none of the files that are to be handed in ({}.cpp and so on)",
                     config.tasks[0].slug);
}

// Returns why it could not be judged; empty if it was.
std::string run_grade(const ClassRequest& request, const intake::HandedIn& by,
                      const std::string& path) {
  std::vector<std::string> command{request.grade,
                                   "--submission=" + by.folder,
                                   "--name=" + by.name,
                                   "--json=" + path + ".json",
                                   "--html=" + path + ".html",
                                   "--seed=" + std::to_string(request.seed)};
  if (request.jobs > 1) command.push_back("--threads=" + std::to_string(threads_each(request)));
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

std::vector<intake::HandedIn> handed_in(const ClassRequest& request) {
  const std::string program = fs::path(request.grade).parent_path() / "unpack";
  const auto unpack = [&](const std::string& archive, const std::string& folder) {
    const process::CommandResult run = process::run_command(
        {{program, archive, folder}, {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"}, {}, "", {}},
        kMaxUnpacking);
    if (run.ok()) return std::string();
    if (!run.timed_out && WIFEXITED(run.status)) return base::printable(run.output, kMaxReason);
    return fmt::format("'{}' cannot be unpacked: {}", fs::path(archive).filename().string(),
                       process::fault_of(run));
  };
  return intake::handed_in(request.input, request.out + "/unpacked", unpack);
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
                 const intake::HandedIn& by) {
  Graded graded{by, {}, by.problem, false};
  const std::string path = request.out + "/" + by.name;
  try {
    if (graded.problem.empty()) graded.problem = why_nothing(config, by.folder);
    if (!graded.problem.empty()) {
      // Of another call, when there was something to judge.
      for (const char* ending : {".json", ".html", ".key"}) fs::remove(path + ending);
      return graded;
    }
    const std::string key = key_of(config, request, by.folder);
    graded.again = has_reports(path, key);
    if (!graded.again) {
      fs::remove(path + ".key");  // the run may end before its reports are whole
      graded.problem = run_grade(request, by, path);
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

void Returns::add(const Graded& graded) {
  const bool judged = graded.problem.empty();
  const results::Totals sums = results::totals(graded.results.tasks);
  max_points_ = std::max(max_points_, sums.max_points);
  all_.push_back({graded.by,
                  {graded.by.name, graded.by.id, judged, sums.points + sums.bonus_points,
                   judged ? results::verdict(graded.results) : graded.problem}});
}

std::vector<std::string> Returns::write(const ClassRequest& request) const {
  auto all = all_;  // in the order in which they were graded
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return a.first.name < b.first.name; });
  std::vector<report::GradeRow> canvas, moodle;
  std::vector<intake::Packed> pages;
  for (const auto& [by, row] : all) {
    if (by.platform == intake::Platform::canvas) canvas.push_back(row);
    if (by.platform == intake::Platform::moodle) moodle.push_back(row);
    if (!row.judged || by.feedback.empty()) continue;
    pages.push_back({by.feedback, request.out + "/" + by.name + ".html"});
  }
  std::vector<std::string> written;
  const auto write_table = [&](const std::string& name, const std::string& text) {
    written.push_back(request.out + "/" + name);
    pt::write_file(written.back(), text);
  };
  const std::string assignment = fs::path(request.input).stem();
  if (!canvas.empty()) {
    write_table("canvas.csv", report::canvas_csv(canvas, assignment, max_points_));
  }
  if (!moodle.empty()) write_table("moodle.csv", report::moodle_csv(moodle, max_points_));
  if (!pages.empty()) {
    written.push_back(request.out + "/feedback.zip");
    intake::pack(written.back(), pages);
  }
  return written;
}

std::string class_header(const judge::Config& config) {
  std::string text = std::string(report::kByteOrderMark) +
                     "submission,id,late,tasks_passed,points,max_points,bonus_points";
  for (const judge::TaskConfig& task : config.tasks)
    text += fmt::format(",{0},{0}_points", task.slug);
  return text + ",problem\r\n";
}

std::string class_line(const judge::Config& config, const Graded& graded) {
  const bool judged = graded.problem.empty();
  const results::Totals sums = results::totals(graded.results.tasks);
  std::string text =
      fmt::format("{},{},{}", report::csv_field(results::one_line(graded.by.name)),
                  report::csv_field(results::one_line(graded.by.id)), graded.by.late ? "late" : "");
  text += judged ? fmt::format(",{},{},{},{}", sums.passed, sums.points, sums.max_points,
                               sums.bonus_points)
                 : ",,,,";
  for (const judge::TaskConfig& task : config.tasks) {
    const results::TaskResult* found = judged ? find_task(graded.results, task.slug) : nullptr;
    text += found == nullptr ? ",,"
                             : fmt::format(",{},{}", results::words(found->state),
                                           found->points + found->bonus_points);
  }
  return text + "," + report::csv_field(results::one_line(graded.problem)) + "\r\n";
}

}  // namespace grader::programs
