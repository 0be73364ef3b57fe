#pragma once

#include "grader/results/results.h"

#include <string>
#include <vector>

namespace grader::judge {

// The known mistakes that explain at least one of these pictures of a task, and that no picture
// contradicts.
std::vector<std::string> candidates(const std::vector<results::PictureResult>& pictures);

// Enters the only candidate, if there is one alone, into the pictures that it makes, with its
// sentence from `file` (grader/pictures/name_mistake.h). Empties their lists of mistakes. Where the
// task's mistake is named already, by its promises and answers, and the pictures contradict that,
// nothing is named at all.
void name_by_pictures(results::TaskResult& task, const std::string& file);

}  // namespace grader::judge
