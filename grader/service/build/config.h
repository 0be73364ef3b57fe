#pragma once

#include <map>
#include <string>
#include <vector>

namespace grader::build {

using Paths = std::vector<std::string>;

// The settings of one task.
struct TaskConfig {
  std::string part;    // "1_rays"
  std::string number;  // "1.3"
  std::string slug;
  std::string graded;  // the property program; empty if the task has no properties
  Paths reference;     // objects

  std::string file() const { return part + "/" + slug + ".cpp"; }
};

// The settings for building workers: written by CMake for this build
// (cmake/grade_json.cmake), trusted.
struct Config {
  std::string root;  // the project's folder
  std::string work;  // where `grade` keeps its builds
  std::string compiler;
  std::vector<std::string> compile_flags;  // without the folder of the headers
  std::vector<std::string> link_flags;
  std::vector<std::string> recording_flags;  // linker flags of a worker that records
  Paths framework;                           // objects of every worker
  Paths recording;                           // more objects of a worker that records
  Paths radiance;                            // objects of the renderer's radiance()
  std::map<std::string, Paths> callbacks;    // by slug or "radiance": objects
  std::string picture;                       // the program graded_picture
  std::string version;                       // of the project: "1.0.0"
  std::string compiler_version;              // "GNU 12.2.0"
  std::string no_reference;                  // why the reference is all stubs here; else empty
  std::vector<TaskConfig> tasks;             // in the order of the course
};

// The file that CMake wrote into the folder of the programs.
std::string default_config_path();

// Throws pt::Error if the file is not there.
Config load_config(const std::string& path);

}  // namespace grader::build
