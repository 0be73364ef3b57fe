#pragma once

#include <filesystem>
#include <string>

namespace grader::self_check {

// The outcome of one task's properties on one submitted file.
struct Verdict {
  bool compiled = false;
  bool passed = false;   // all selected properties held, and at least one was selected
  bool crashed = false;  // by a signal, or killed by a limit
  std::string output;    // of the compiler, or of the properties
  std::string audit;     // the reason for which `grade` would reject it; empty if none
};

// Compiles the file as a submission of the task, links it to the task's properties, with the
// reference in all other places, and runs those whose names match `filter` (as GoogleTest has it),
// under limits on time and memory. Safe from any thread for different `scratch` names.
Verdict judge(const std::string& slug, const std::filesystem::path& file, const std::string& filter,
              const std::string& scratch);

}  // namespace grader::self_check
