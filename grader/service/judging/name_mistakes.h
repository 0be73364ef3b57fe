#pragma once

#include "grader/service/judging/alone.h"

#include <functional>
#include <vector>

namespace grader::judging {

// The file of a task's known mistakes, next to the program that runs its battery.
std::string known_path(const build::TaskConfig& task);

// Names the mistake of each task that is not right alone, if only one known mistake explains the
// findings of its promises and its battery (grader/mistakes/naming.h). A task that shows nothing but black, zeros or misses has no
// name: many mistakes look like that. Says also how alike each task is to known mistakes; where one is named, it is that alone. Call it after
// judge_alone.
// `progress` is called after every named task, by one thread at a time.
void name_mistakes(const build::Config& config, const build::Builder& builder,
                   const GradeRequest& request, std::vector<Judged>& judged,
                   const std::function<void()>& progress);

}  // namespace grader::judging
