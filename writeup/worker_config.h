#pragma once

#include "grader/judge/config.h"

#include <map>
#include <string>

namespace writeup {

// As `grade` has it, but for what workers are linked from besides tasks: that is in the file of this name beside the
// program that runs.
grader::judge::Config worker_config(const std::string& name);

// The objects of the faster forms of tasks, by slug, from the same file; none if it names none.
std::map<std::string, grader::judge::Paths> fast_objects(const std::string& name);

}  // namespace writeup
