#pragma once

#include "grader/door/clone.h"
#include "grader/service/sandbox/box.h"

#include <string>

namespace grader::intake {

// Writes the twelve task files of a clone of the course (grader/door/flatten.h) to `folder`, with the
// program `flatten` in the folder `programs`, in a box: the files of a clone are somebody else's.
// `name` is the clone's, for messages. Returns why that failed, in one sentence; else an empty text.
// Throws pt::Error if the machine is at fault.
std::string flatten_boxed(const std::string& name, const door::Clone& clone,
                          const std::string& root, const std::string& programs, sandbox::Tier tier,
                          const std::string& folder);

}  // namespace grader::intake
