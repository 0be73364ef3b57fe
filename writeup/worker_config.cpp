#include "writeup/worker_config.h"

#include "pt/file.h"

#include <filesystem>

#include <nlohmann/json.hpp>

namespace writeup {

namespace {

constexpr std::size_t kMaxJson = std::size_t{1} << 22;

nlohmann::json changes(const std::string& name) {
  const auto folder = std::filesystem::path(grader::judge::default_config_path()).parent_path();
  return nlohmann::json::parse(pt::read_file(folder / name, kMaxJson));
}

}  // namespace

grader::judge::Config worker_config(const std::string& name) {
  grader::judge::Config config = grader::judge::load_config(grader::judge::default_config_path());
  const nlohmann::json json = changes(name);
  json.at("recording_flags").get_to(config.recording_flags);
  json.at("framework").get_to(config.framework);
  json.at("recording").get_to(config.recording);
  json.at("radiance").get_to(config.radiance);
  return config;
}

std::map<std::string, grader::judge::Paths> fast_objects(const std::string& name) {
  return changes(name).value("fast", std::map<std::string, grader::judge::Paths>());
}

}  // namespace writeup
