#pragma once

#include "grader/judge/alone.h"

#include <functional>
#include <vector>

namespace grader::judge {

// The file of the known mistakes of a task, beside the program that runs its battery.
std::string known_path(const TaskConfig& task);

// Names the mistake of each task that is not right by itself, where one known mistake alone
// explains what its promises and its battery found (grader/mistakes/naming.h). To be called after
// judge_alone; `progress` is called after every task that is named, by one thread at a time.
void name_mistakes(const Config& config, const Builder& builder, const GradeRequest& request,
                   std::vector<Judged>& judged, const std::function<void()>& progress);

}  // namespace grader::judge
