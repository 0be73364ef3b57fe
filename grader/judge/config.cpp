#include "grader/judge/config.h"

#include "grader/base/files.h"
#include "grader/base/json_text.h"
#include "grader/tasks.h"
#include "pt/error.h"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::judge {

std::string default_config_path() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "grade.json";
}

namespace {

Config config_from(const nlohmann::json& json) {
  Config config;
  json.at("root").get_to(config.root);
  json.at("work").get_to(config.work);
  json.at("compiler").get_to(config.compiler);
  json.at("compile_flags").get_to(config.compile_flags);
  json.at("link_flags").get_to(config.link_flags);
  json.at("recording_flags").get_to(config.recording_flags);
  json.at("framework").get_to(config.framework);
  json.at("recording").get_to(config.recording);
  json.at("radiance").get_to(config.radiance);
  json.at("callbacks").get_to(config.callbacks);
  json.at("picture").get_to(config.picture);
  json.at("compiler_version").get_to(config.compiler_version);
  json.at("no_reference").get_to(config.no_reference);
  for (const auto& task : json.at("tasks")) {
    const Task& row = task_of(task.at("slug").get<std::string>());
    config.tasks.push_back(
        {row.part, row.number, row.slug, task.at("graded"), task.at("reference")});
  }
  return config;
}

}  // namespace

Config load_config(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) {
    throw pt::Error(path + " is missing: build the target grade");
  }
  try {
    return config_from(nlohmann::json::parse(base::read_file(path)));
  } catch (const nlohmann::json::exception& error) {
    throw pt::Error(fmt::format("{} is not what CMake wrote ({}); build the target grade again",
                                path, base::words_of(error)));
  }
}

}  // namespace grader::judge
