#pragma once

#include "grader/tasks.h"

#include <string>
#include <string_view>

namespace grader::audit {

// Returns whether a task may call a function of another file, such as "pt::Scene::closest". Its
// grader/tasks/<slug>/task.json lists the tasks and functions; "May call: ..." in its contract says
// the same. A function that is defined in a header belongs to the task that includes it.
bool may_call(const Task& task, std::string_view function);

// A sentence: "hit_bvh may only call hit_box and pt::radiance", or that it calls nothing.
std::string may_call_in_words(const Task& task);

}  // namespace grader::audit
