#pragma once

#include <string_view>

namespace pt {

// Called by a task that is not written yet, before it returns a neutral value. The first call with
// a slug prints one line to standard error; the program goes on. Safe from any thread.
void todo(std::string_view slug);

// Returns whether todo(slug) was called in this process: a task that reached it counts as not
// attempted.
bool todo_reached(std::string_view slug);

}  // namespace pt
