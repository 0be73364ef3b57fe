#pragma once

#include "grader/judge/alone.h"

namespace grader::judge {

// The learners' edition brings the reference as objects. On a machine on which they do not fit
// there is none, and a task can only be judged together with the submission's other tasks.

// The configuration in which the submission's own tasks, where they compile, stand for the
// reference.
Config with_own_tasks(Config config, const std::vector<Judged>& judged);

// A task that fails may do so because a task that it calls is wrong: then it waits for that one.
void block_by_own_tasks(std::vector<Judged>& judged);

// The tasks that have to be right before a picture by these can be: they and all that come before.
std::vector<std::string> missing_for(const std::vector<std::string>& slugs,
                                     const std::vector<Judged>& judged);

}  // namespace grader::judge
