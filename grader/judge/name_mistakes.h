#pragma once

#include "grader/judge/alone.h"

#include <functional>
#include <vector>

namespace grader::judge {

// Names the mistake of each task that is not right by itself, where one known mistake alone
// explains what its promises and its battery found (grader/mistakes/naming.h). To be called after
// judge_alone; `progress` is called after every task that is named, by one thread at a time.
void name_mistakes(const Config& config, const Builder& builder, const GradeRequest& request,
                   std::vector<Judged>& judged, const std::function<void()>& progress);

// The hint for the named mistake of a task, in one line: the second one (a direction) for its most
// telling broken promise. The third ones name usual mistakes, which may be others than this. Empty
// where the task has no hints.
std::string hint_for(const Config& config, const results::TaskResult& task);

}  // namespace grader::judge
