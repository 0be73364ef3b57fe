#pragma once

#include <map>
#include <string>
#include <vector>

namespace grader::judge {

using Paths = std::vector<std::string>;

// What the build knows about one task.
struct TaskConfig {
  std::string part;    // "1_rays"
  std::string number;  // "1.3"
  std::string slug;
  std::string graded;  // the property program; empty if the task has no properties
  Paths reference;     // objects

  std::string file() const { return part + "/" + slug + ".cpp"; }
};

// How to build workers: written by CMake for this build (grader/programs/CMakeLists.txt), trusted.
struct Config {
  std::string root;  // of the project
  std::string work;  // where `grade` keeps what it builds
  std::string compiler;
  std::vector<std::string> compile_flags;  // but where the headers are
  std::vector<std::string> link_flags;
  std::vector<std::string> recording_flags;  // for the linker, of the integrated worker
  Paths framework;                           // objects of every worker
  Paths recording;                           // and of the integrated one
  Paths radiance;                            // the implementation path
  std::map<std::string, Paths> callbacks;    // by slug or "radiance": objects
  std::string picture;                       // the program graded_picture
  std::string compiler_version;              // "g++ 12.2.0"
  std::string no_reference;                  // why what is called so are stubs; empty: it is none
  std::vector<TaskConfig> tasks;             // in the order of the course
};

// The file that CMake wrote next to the program that runs.
std::string default_config_path();

// Throws pt::Error if the file is not there.
Config load_config(const std::string& path);

}  // namespace grader::judge
