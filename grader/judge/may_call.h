#pragma once

#include "grader/tasks.h"

#include <string>
#include <string_view>

namespace grader::judge {

// Returns whether a task may call the function, "pt::Scene::closest", which is not in its own file:
// the tasks and functions in its grader/tasks/<slug>/task.json. Functions that are whole in a header
// are the task's own once it includes them. The contract of the task says the same, in the sentence
// "May call: ...".
bool may_call(const Task& task, std::string_view function);

// "hit_bvh may only call hit_box and pt::radiance", or that it calls nothing: for a person to read.
std::string may_call_in_words(const Task& task);

}  // namespace grader::judge
