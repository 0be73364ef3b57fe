#include "measure/renders/worker_config.h"

#include "grader/base/files.h"
#include "pt/file.h"

#include <nlohmann/json.hpp>

namespace measure {

namespace {

constexpr std::size_t kMaxJson = std::size_t{1} << 22;

nlohmann::json changes(const std::string& name) {
  const std::string file = grader::base::programs_folder() + "/../measure/" + name;
  return nlohmann::json::parse(pt::read_file(file, kMaxJson));
}

}  // namespace

grader::build::Config worker_config(const std::string& name) {
  grader::build::Config config = grader::build::load_config(grader::build::default_config_path());
  const nlohmann::json json = changes(name);
  // Nobody's code is measured with the checks (cmake/options.cmake): they take a quarter of build_bvh's time.
  std::erase(config.compile_flags, "-D_GLIBCXX_ASSERTIONS");
  json.at("recording_flags").get_to(config.recording_flags);
  json.at("framework").get_to(config.framework);
  json.at("recording").get_to(config.recording);
  json.at("radiance").get_to(config.radiance);
  return config;
}

grader::build::Config recorded(grader::build::Config config) {
  config.framework.insert(config.framework.end(), config.recording.begin(), config.recording.end());
  config.link_flags.insert(config.link_flags.end(), config.recording_flags.begin(),
                           config.recording_flags.end());
  return config;
}

std::map<std::string, grader::build::Paths> fast_objects(const std::string& name) {
  return changes(name).value("fast", std::map<std::string, grader::build::Paths>());
}

}  // namespace measure
