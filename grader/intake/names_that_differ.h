#pragma once

#include "grader/intake/handed_in.h"

#include <vector>

namespace grader::intake {

// The submissions in alphabetical order, each with a name that can be that of its reports: unlike those of
// all others, and of the files for the class as a whole. Namesakes get their IDs, or numbers.
std::vector<HandedIn> with_names_that_differ(std::vector<HandedIn> all);

}  // namespace grader::intake
