#pragma once

#include "grader/mistakes/known.h"
#include "grader/service/judging/findings.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace grader::judging {

// A task's answers to its battery, from the cache if possible. `seed` is for the random draws;
// their number is `draws` times the usual number. Nothing if the program fails. Safe from any
// thread.
std::optional<mistakes::Answers> ask_battery(const build::Builder& builder, const Trial& trial,
                                             std::uint64_t seed, int draws);

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
