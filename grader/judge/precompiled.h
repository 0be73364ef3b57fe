#pragma once

#include "grader/judge/config.h"
#include "grader/judge/headers.h"
#include "grader/judge/tool_folder.h"

#include <array>
#include <mutex>
#include <string>
#include <vector>

namespace grader::judge {

// Precompiles the two headers that take most of the compiler's time: one that every task includes,
// and one for tasks that see the scene. With them, a file of a task compiles to the same instructions
// in a fifth of the time.
//
// They are made when the first file asks for them, in <work>/headers (85 MB), and stay for all
// later runs. Only g++ has them.
class PrecompiledHeaders {
 public:
  PrecompiledHeaders(const Config& config, Headers headers);

  // More options of the compiler for this text of a task's file: "-include" and a path, or nothing,
  // where headers cannot be precompiled or could change what the text means. Safe from any
  // thread.
  std::vector<std::string> flags_for(const TaskConfig& task, const std::string& text) const;

  // The folder in which they are, for a box to read.
  const std::string& folder() const { return folder_; }

 private:
  struct Header {
    std::string included;  // "pt/scene/scene.h"
    mutable std::once_flag once;
    mutable bool there = false;
  };
  std::string path_of(const Header& header) const;
  void make(const Header& header) const;
  // Compiles a header in a folder that has those that it includes.
  bool compiled(const std::string& path, const std::string& folder,
                const std::string& output) const;

  const Config& config_;
  Headers headers_;
  std::string folder_;
  std::array<Header, 2> kept_;  // the one that includes the other last
};

}  // namespace grader::judge
