#pragma once

#include "grader/judge/isolation.h"

namespace grader {

// Judges again, together with the submission's other tasks, every task that is right by itself and
// asks others: its state becomes blocked where one of those is not right itself, and fails where
// only the combination does; then the tasks are named with whose reference it would pass.
void judge_together(const Config& config, const Builder& builder, const GradeRequest& request,
                    std::vector<Judged>& judged);

}  // namespace grader
