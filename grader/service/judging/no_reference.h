#pragma once

#include "grader/service/judging/alone.h"

namespace grader::judging {

// The learners' edition contains the reference as objects. On a machine that cannot link them there
// is no reference, and a task can only be judged together with the submission's other tasks.

// The configuration in which the submission's own tasks replace the reference, if they compile.
build::Config with_own_tasks(build::Config config, const std::vector<Judged>& judged);

// A task that fails and calls a wrong task is blocked: the wrong task may be the reason.
void block_by_own_tasks(std::vector<Judged>& judged);

// The tasks that a right picture needs: the given tasks and all earlier tasks.
std::vector<std::string> missing_for(const std::vector<std::string>& slugs,
                                     const std::vector<Judged>& judged);

}  // namespace grader::judging
