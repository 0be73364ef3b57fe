#include "grader/report/json.h"

#include "pt/error.h"

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace grader {

namespace {

using nlohmann::ordered_json;

ordered_json describe(const FailureReport& failure) {
  return {{"input", failure.input},
          {"what", failure.what},
          {"got", failure.got},
          {"expected", failure.expected},
          {"off_by", failure.off_by},
          {"cause", failure.cause},
          {"cases_before", failure.cases_before},
          {"seed", failure.seed},
          {"integrated", failure.integrated},
          {"replay", failure.replay}};
}

ordered_json describe(const PromiseResult& promise) {
  ordered_json failures = ordered_json::array();
  for (const FailureReport& failure : promise.failures) failures.push_back(describe(failure));
  return {{"name", promise.name}, {"words", promise.words},     {"bonus", promise.bonus},
          {"held", promise.held}, {"seconds", promise.seconds}, {"failures", failures}};
}

ordered_json describe(const PictureResult& picture) {
  return {{"recipe", picture.recipe}, {"state", name(picture.state)}, {"text", picture.text}};
}

ordered_json describe(const TaskResult& task) {
  ordered_json promises = ordered_json::array(), pictures = ordered_json::array();
  for (const PromiseResult& promise : task.promises) promises.push_back(describe(promise));
  for (const PictureResult& picture : task.pictures) pictures.push_back(describe(picture));
  return {{"part", task.part},
          {"number", task.number},
          {"slug", task.slug},
          {"state", name(task.state)},
          {"reason", task.reason},
          {"points", task.points},
          {"max_points", task.max_points},
          {"bonus_points", task.bonus_points},
          {"blocked_by", task.blocked_by},
          {"blamed", task.blamed},
          {"compiler_output", task.compiler_output},
          {"printed", task.printed},
          {"promises", promises},
          {"pictures", pictures}};
}

}  // namespace

std::string to_json(const Results& results) {
  ordered_json tasks = ordered_json::array();
  for (const TaskResult& task : results.tasks) tasks.push_back(describe(task));
  const ordered_json all{{"schema_version", kSchemaVersion},
                         {"complete", results.complete},
                         {"passed", results.complete && passes(results)},
                         {"submission", results.submission},
                         {"asked", results.asked},
                         {"seed", results.seed},
                         {"isolation", results.isolation},
                         {"seconds", results.seconds},
                         {"tasks", tasks}};
  // Texts may hold what a submission printed or threw, which need not be UTF-8.
  return all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

void write_json(const Results& results, const std::string& path) {
  const std::string temporary = path + ".part" + std::to_string(getpid());
  std::ofstream file(temporary);
  file << to_json(results);
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(temporary, path, error);
  if (!file || error) throw pt::Error(path + ": cannot be written; choose another --json");
}

}  // namespace grader
