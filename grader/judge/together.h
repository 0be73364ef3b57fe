#pragma once

#include "grader/judge/alone.h"

#include <stop_token>

namespace grader::judge {

// Links a worker with all tasks that are right by themselves. The reference takes the place of all others,
// and of the task `swapped`. radiance() is the judge's answer for properties, the renderer's for pictures.
Built link_together(const Config& config, const Builder& builder, const std::vector<Judged>& judged,
                    Elsewhere elsewhere, const std::string& swapped = "");

// Judges again, together with the submission's other tasks, every task that is right by itself and
// calls others: its state becomes blocked where one of those is not right itself, and fails where
// only the combination does: then the result names the tasks with whose reference it would pass. Settles
// all tasks. `progress` is called after every task that passes, by one thread at a time.
void judge_together(const Config& config, const Builder& builder, const GradeRequest& request,
                    std::vector<Judged>& judged, const std::function<void()>& progress);

// For the one task that is asked for, while it is still judged by itself and a processor is idle:
// judges it together with the others, as if it were right. The verdict lies in the cache, where
// judge_together finds it. Does nothing where several tasks are asked for, or another one is not
// right by itself; ends without a verdict where `stop` asks for that.
void judge_ahead(const Config& config, const Builder& builder, const GradeRequest& request,
                 std::vector<Judged> judged, const std::stop_token& stop);

}  // namespace grader::judge
