#include "grader/programs/examples_in_results.h"

#include "grader/base/files.h"
#include "grader/base/json_text.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/box.h"
#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::programs {

namespace {

using nlohmann::json;

// Returns the counts of `grade_examples --counts`.
json counts_of(const build::Config& config, const std::string& config_path,
               const std::string& submission, const std::vector<std::string>& slugs) {
  const std::string program = base::programs_folder() + "/grade_examples";
  if (!std::filesystem::exists(program))
    throw pt::Error(
        "grader/points.json has points for examples, and grade_examples, which judges them, is not "
        "built: ./run grade builds it");
  const std::string path = fmt::format("{}/counts.{}.json", config.work, getpid());
  std::vector<std::string> command{program,     "--submission", submission, "--config",
                                   config_path, "--counts",     path};
  command.insert(command.end(), slugs.begin(), slugs.end());
  const process::CommandResult result = process::run_command(
      {command, sandbox::judges_environment(), {}, "", {}}, process::kProgramTime);
  if (!result.ok())
    throw pt::Error("the examples could not be judged: " + process::fault_of(result));
  json counts = base::parse_json(pt::read_file(path), path);
  std::filesystem::remove(path);
  return counts;
}

results::PromiseResult row_of(const json& counts) {
  const int caught = counts.at("caught"), all = counts.at("all");
  results::PromiseResult row;
  row.name = results::kExamples + counts.at("promise").get<std::string>();
  row.words =
      fmt::format("examples catch what breaks \"{}\"", counts.at("title").get<std::string>());
  row.bonus = true;
  row.held = caught == all;
  row.checks = all;
  if (!row.held) {
    results::Failure& failure = row.failures.emplace_back();
    failure.got = fmt::format("{} of {} wrong solutions caught", caught, all);
    failure.expected = "all of them";
  }
  return row;
}

}  // namespace

std::vector<std::string> with_points_for_examples(const results::Points& points,
                                                  const std::vector<std::string>& slugs) {
  std::vector<std::string> all;
  for (const std::string& slug : slugs) {
    const auto found = points.find(slug);
    if (found != points.end() && found->second.examples > 0) all.push_back(slug);
  }
  return all;
}

void add_examples(const build::Config& config, const std::string& config_path,
                  const std::string& submission, results::Results& results) {
  const results::Points points = results::load_points(config.root + "/grader/points.json");
  std::vector<std::string> slugs;
  for (const results::TaskResult& task : results.tasks) {
    const base::Submitted file =
        base::read_submitted(submission, task.part, task.slug + ".examples");
    if (file.present && file.rejected.empty()) slugs.push_back(task.slug);
  }
  slugs = with_points_for_examples(points, slugs);
  if (slugs.empty()) return;
  const json counts = counts_of(config, config_path, submission, slugs);
  for (results::TaskResult& task : results.tasks) {
    if (!counts.contains(task.slug)) continue;
    for (const json& row : counts.at(task.slug)) task.promises.push_back(row_of(row));
    results::count_points(points, task);
  }
}

}  // namespace grader::programs
