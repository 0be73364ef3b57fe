#pragma once

#include "grader/service/build/config.h"

#include <map>
#include <string>

namespace measure {

// The configuration of `grade`, with other objects for workers besides tasks: they are in the file
// of this name next to the running program.
grader::build::Config worker_config(const std::string& name);

// The same for workers that record the calls of tasks (pt/scene/recorder.h), however they are linked.
grader::build::Config recorded(grader::build::Config config);

// The objects of the faster forms of tasks, by slug, from the same file; may be empty.
std::map<std::string, grader::build::Paths> fast_objects(const std::string& name);

}  // namespace measure
