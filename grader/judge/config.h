#pragma once

#include <map>
#include <string>
#include <vector>

namespace grader::judge {

using Paths = std::vector<std::string>;

// The build's knowledge of one task.
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
  std::string root;  // of the project
  std::string work;  // where `grade` keeps what it builds
  std::string compiler;
  std::vector<std::string> compile_flags;  // all but the folder of the headers
  std::vector<std::string> link_flags;
  std::vector<std::string> recording_flags;  // for the linker, of the integrated worker
  Paths framework;                           // objects of every worker
  Paths recording;                           // and of the integrated one
  Paths radiance;                            // the implementation path
  std::map<std::string, Paths> callbacks;    // by slug or "radiance": objects
  std::string picture;                       // the program graded_picture
  std::string compiler_version;              // "GNU 12.2.0"
  std::string no_reference;       // why the reference consists of stubs here; empty: it does not
  std::vector<TaskConfig> tasks;  // in the order of the course
};

// The file that CMake wrote next to the program that runs.
std::string default_config_path();

// Throws pt::Error if the file is not there.
Config load_config(const std::string& path);

}  // namespace grader::judge
