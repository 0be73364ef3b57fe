#pragma once

#include "grader/service/judging/alone.h"

#include <atomic>

namespace grader::judging {

// Links a worker with all tasks that are right alone. The reference replaces all other tasks, and
// the task `swapped`. radiance() is the judge's for properties, the renderer's for pictures.
build::Built link_together(const build::Config& config, const build::Builder& builder,
                           const std::vector<Judged>& judged, Elsewhere elsewhere,
                           const std::string& swapped = "");

// Judges again, together with the submission's other tasks, every task that is right alone and
// calls others. Its state becomes `blocked` if one of those is wrong. It becomes `fails` if only
// the combination fails; then the result names the tasks whose reference would make it pass.
// Settles all tasks. `progress` is called after every task that passes, by one thread at a time.
void judge_together(const build::Config& config, const build::Builder& builder,
                    const GradeRequest& request, std::vector<Judged>& judged,
                    const std::function<void()>& progress);

// Judges the only requested task together with the others, as if it were right, while it is still
// judged alone and a processor is idle. The verdict goes to the cache, where judge_together finds
// it. Does nothing if several tasks are requested, or if another task is not right alone. Ends
// without a verdict if `stop` requests it.
void judge_ahead(const build::Config& config, const build::Builder& builder,
                 const GradeRequest& request, std::vector<Judged> judged,
                 const std::atomic<bool>& stop);

}  // namespace grader::judging
