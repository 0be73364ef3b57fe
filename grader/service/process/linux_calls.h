#pragma once

// For spawn.cpp: what only Linux can do for a child. With FIRSTLIGHT_SERVICE off, no_linux_calls.cpp takes the place of
// linux_calls.cpp and process_time.cpp: then all programs are our own, and a time limit is one by the clock.

namespace grader::process {

// Makes this process die with the thread that started it, and gain no privileges. Allocates nothing, like close_from.
void stay_with_parent();

// Closes all descriptors from this number on.
void close_from(int first);

// Makes this process adopt the orphans of its children, and reaps those that have ended.
void reap_orphans();

}  // namespace grader::process
