#include "grader/service/build/config.h"

#include "grader/base/files.h"
#include "grader/base/json_text.h"
#include "grader/tasks.h"
#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::build {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Config, root, work, compiler, compile_flags, link_flags,
                                   recording_flags, framework, recording, radiance, callbacks,
                                   picture, version, compiler_version, no_reference)

std::string default_config_path() { return base::programs_folder() + "/grade.json"; }

namespace {

Config config_from(const nlohmann::json& json) {
  Config config = json;
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
    return config_from(nlohmann::json::parse(pt::read_file(path)));
  } catch (const nlohmann::json::exception& error) {
    throw pt::Error(fmt::format("{} is not what CMake wrote ({}); build the target grade again",
                                path, base::words_of(error)));
  }
}

}  // namespace grader::build
