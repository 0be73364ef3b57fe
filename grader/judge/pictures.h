#pragma once

#include "grader/judge/alone.h"
#include "grader/pictures/recipes.h"

namespace grader::judge {

// Enters the recipes that show the tasks asked for into their results, not judged so far.
void list_pictures(const Config& config, const GradeRequest& request, std::vector<Judged>& judged);

// Renders the recipes that are listed, and enters the verdicts. A picture that passes with all
// tasks of the submission that are right by themselves passes for each of them; where it does not,
// each task is rendered by itself, the reference elsewhere. A task that fails its promises already
// is rendered by itself, one round only. A known mistake that alone explains all pictures of its
// task is named. Sample maps are always judged by themselves.
// `progress` is called after every recipe, by one thread at a time.
void judge_pictures(const Config& config, const Builder& builder, const GradeRequest& request,
                    std::vector<Judged>& judged, const std::function<void()>& progress);

}  // namespace grader::judge
