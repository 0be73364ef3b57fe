#pragma once

#include "grader/pictures/recipes/recipes.h"
#include "grader/service/judging/alone.h"

namespace grader::judging {

// Adds the recipes that show the requested tasks to their results, not judged so far. Throws
// pt::Error if a golden of theirs has been exchanged.
void list_pictures(const build::Config& config, const GradeRequest& request,
                   std::vector<Judged>& judged);

// Renders the listed recipes, and enters the verdicts. A picture that passes with all tasks that
// are right alone passes for each of them; if it fails, each task is rendered with the reference
// elsewhere. A task that breaks a promise is rendered alone, for one round only; one that
// does not answer in time is rendered once. If only one known
// mistake explains all pictures of a task, it is named. Sample maps are always judged alone.
// `progress` is called after every recipe, by one thread at a time.
void judge_pictures(const build::Config& config, const build::Builder& builder,
                    const GradeRequest& request, std::vector<Judged>& judged,
                    const std::function<void()>& progress);

}  // namespace grader::judging
