#pragma once

#include "grader/judge/findings.h"

#include <chrono>
#include <string>
#include <vector>

namespace grader::judge {

// A file that a property program wrote.
struct Written {
  std::string path;   // empty if the program failed
  std::string error;  // what it said then
};

// Runs the property program of a trial's task on the worker with these words, of which the last is an
// option that takes the name of the file to write. What an earlier run wrote is used again. Safe from
// any thread.
Written ask_graded(const Builder& builder, const Trial& trial,
                   const std::vector<std::string>& words, std::chrono::seconds most);

}  // namespace grader::judge
