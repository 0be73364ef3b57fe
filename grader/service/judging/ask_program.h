#pragma once

#include "grader/service/judging/findings.h"

#include <chrono>
#include <string>
#include <vector>

namespace grader::judging {

// A file that a program of one task wrote (graded.<slug>, stability.<slug>).
struct Written {
  std::string path;   // empty if the program failed
  std::string error;  // its message if it failed
};

// Runs a program of the trial's task on the trial's worker. The last word is an option that takes
// the name of the file to write. The file of an earlier run is reused. Safe from any thread.
Written ask_program(const build::Builder& builder, const std::string& program, const Trial& trial,
                    const std::vector<std::string>& words, std::chrono::seconds most);

}  // namespace grader::judging
