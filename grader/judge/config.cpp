#include "grader/judge/config.h"

#include "pt/error.h"

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

namespace grader {

namespace {

using Slugs = std::vector<std::string>;

const Slugs kTracing{"hit_triangle", "hit_sphere", "build_bvh", "hit_box", "hit_bvh"};

Slugs operator+(Slugs all, const Slugs& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

std::string default_config_path() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "grade.json";
}

Config load_config(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw pt::Error(path + " is missing: build the target grade");
  const nlohmann::json json = nlohmann::json::parse(file);
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
    config.tasks.push_back({task.at("part"), task.at("number"), task.at("slug"), task.at("graded"),
                            task.at("reference")});
  }
  return config;
}

const Slugs& needs(const std::string& slug) {
  static const std::map<std::string, Slugs> all{
      {"estimate_pixel", {"camera_ray"}},
      {"hit_bvh", {"hit_triangle", "hit_sphere", "hit_box"}},
      {"direct_hemisphere", kTracing + Slugs{"diffuse_bsdf"}},
      {"direct_lights", kTracing + Slugs{"diffuse_bsdf"}},
      {"trace_path", kTracing + Slugs{"diffuse_bsdf", "direct_hemisphere", "direct_lights"}},
      {"adaptive_pixel", {"camera_ray"}},
  };
  static const Slugs none;
  const auto found = all.find(slug);
  return found == all.end() ? none : found->second;
}

const Slugs& asks_the_judge(const std::string& slug) {
  static const Slugs none, bvh{"hit_box", "hit_triangle", "hit_sphere"}, pixel{"radiance"},
      path{"diffuse_bsdf"};
  if (slug == "hit_bvh") return bvh;
  if (slug == "trace_path") return path;
  return slug == "estimate_pixel" || slug == "adaptive_pixel" ? pixel : none;
}

}  // namespace grader
