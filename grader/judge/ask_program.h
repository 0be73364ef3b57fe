#pragma once

#include "grader/judge/findings.h"

#include <chrono>
#include <string>
#include <vector>

namespace grader::judge {

// A file that a program of one task wrote (graded.<slug>, stability.<slug>).
struct Written {
  std::string path;   // empty if the program failed
  std::string error;  // what it said then
};

// Runs a program of the trial's task on the trial's worker with these words, of which the last is an option
// that takes the name of the file to write. What an earlier run wrote is used again. Safe from any thread.
Written ask_program(const Builder& builder, const std::string& program, const Trial& trial,
                    const std::vector<std::string>& words, std::chrono::seconds most);

}  // namespace grader::judge
