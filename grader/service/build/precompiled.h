#pragma once

#include "grader/service/build/config.h"
#include "grader/service/build/headers.h"
#include "grader/service/build/tool_folder.h"

#include <array>
#include <mutex>
#include <string>
#include <vector>

namespace grader::build {

// Precompiles the two headers that take most of the compiler's time: one for every task, and one
// for tasks that see the scene. With them, a file of a task compiles to the same instructions in a
// fifth of the time.
//
// They are made when the first file needs them, in <work>/headers (85 MB), and stay for all later
// runs. This is only done for g++.
class PrecompiledHeaders {
 public:
  PrecompiledHeaders(const Config& config, Headers headers);

  // More compiler options for this text of a task's file: "-include" and a path, or none if headers
  // cannot be precompiled or could change what the text means. Safe from any thread.
  std::vector<std::string> flags_for(const TaskConfig& task, const std::string& text) const;

  // The folder of these headers, for a box to read.
  const std::string& folder() const { return folder_; }

 private:
  struct Header {
    std::string included;  // "pt/scene/scene.h"
    mutable std::once_flag once;
    mutable bool there = false;
  };
  std::string path_of(const Header& header) const;
  void make(const Header& header) const;
  // Compiles a header in a folder with the headers that it includes.
  bool compiled(const std::string& path, const std::string& folder,
                const std::string& output) const;

  const Config& config_;
  Headers headers_;
  std::string folder_;
  std::array<Header, 2> kept_;  // the second one includes the first one
};

}  // namespace grader::build
