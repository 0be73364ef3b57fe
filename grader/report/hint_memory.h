#pragma once

#include "grader/results/results.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace grader::report {

// Facts about a task that `grade` keeps for `hint` and for ./run debug, and the hints given so far:
// a text file per task, in the folder hints/ below `work`, with the lines
//   seed 1
//   fails <property>            for each promise that failed, in the order of the report
//   given <step> <property>     no property: the general hint
struct Memory {
  std::uint64_t seed = 1;
  std::vector<std::string> fails;
  std::map<std::string, int> given;  // by property: the last step, counted from 1
};

// Reads the memory; empty if there is none.
Memory recall(const std::string& work, const std::string& slug);

// Writes the whole file or none. Throws pt::Error if it cannot be written.
void remember(const std::string& work, const std::string& slug, const Memory& memory);

// After a run of `grade`: remembers the promises that fail now. The hints of a task that passes
// start again.
void remember_failures(const std::string& work, const results::Results& results);

}  // namespace grader::report
