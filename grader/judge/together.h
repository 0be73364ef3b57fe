#pragma once

#include "grader/judge/alone.h"

namespace grader::judge {

// The worker of all tasks that are right by themselves, and of the reference for all others and for
// `swapped`. radiance() is the judge's answer for properties, the renderer's for pictures.
Built link_together(const Config& config, const Builder& builder, const std::vector<Judged>& judged,
                    Elsewhere elsewhere, const std::string& swapped = "");

// Judges again, together with the submission's other tasks, every task that is right by itself and
// calls others: its state becomes blocked where one of those is not right itself, and fails where
// only the combination does; then the tasks are named with whose reference it would pass. Settles
// all tasks. `progress` is called after every task that passes, by one thread at a time.
void judge_together(const Config& config, const Builder& builder, const GradeRequest& request,
                    std::vector<Judged>& judged, const std::function<void()>& progress);

}  // namespace grader::judge
