#pragma once

#include <string>
#include <vector>

namespace pt {

// From now on todo() prints nothing: the program names all tasks that are not written at once.
void silence_todo();

// The slugs with which todo() was called in this process, in alphabetical order.
std::vector<std::string> todo_list();

}  // namespace pt
