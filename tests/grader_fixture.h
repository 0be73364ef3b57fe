#pragma once

#include "pt/file.h"

#include <filesystem>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

// Surroundings of the grader's programs: a folder of its own for each test, with a grade.json
// for tasks of which nothing has been built.
class GraderFolder {
 public:
  GraderFolder() {
    std::string name = std::filesystem::temp_directory_path() / "firstlight.XXXXXX";
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
    std::filesystem::create_directories(path_ + "/work");
    pt::write_file(
        config(),
        fmt::format(R"({{"root": "{}", "work": "{}/work",
      "compiler": "", "compile_flags": [], "link_flags": [], "recording_flags": [],
      "framework": [], "recording": [], "radiance": [], "picture": "", "no_reference": "",
      "compiler_version": "", "callbacks": {{}}, "tasks": [{},{},{}]}})",
                    FIRSTLIGHT_SOURCE_DIR, path_, task("1_rays", "1.3", "hit_triangle"),
                    task("1_rays", "1.4", "hit_sphere"), task("2_bvh", "2.1", "build_bvh")));
  }
  ~GraderFolder() { std::filesystem::remove_all(path_); }
  GraderFolder(const GraderFolder&) = delete;
  GraderFolder& operator=(const GraderFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string config() const { return path_ + "/grade.json"; }

 private:
  static std::string task(const std::string& part, const std::string& number,
                          const std::string& slug) {
    return fmt::format(
        R"({{"part": "{}", "number": "{}", "slug": "{}", "graded": "", "reference": []}})", part,
        number, slug);
  }

  std::string path_;
};
