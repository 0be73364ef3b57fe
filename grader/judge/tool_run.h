#pragma once

#include "grader/judge/tool_folder.h"
#include "grader/process/run_command.h"
#include "grader/sandbox/box.h"

namespace grader::judge {

// A run of a compiler or a linker in its box. Its output may be a submission's text (#line "bwrap: x"),
// so the other two come from the launcher and the kernel alone.
struct ToolRun {
  process::CommandResult result;
  bool started = false;  // the box was made, and the program began
  bool killed = false;   // SIGKILL ended it, or a part of it that report_parts() knows
};

// For so many seconds at most. The first descriptors of the box are set here.
ToolRun run_tool(sandbox::Box box, sandbox::Tier tier, int seconds);

// The command is gcc's driver: how its parts (cc1plus, as) end is told to run_tool(). Other compilers
// are one process. To be called before words are added to the command.
void report_parts(sandbox::Box& box, const ToolFolder& place);

}  // namespace grader::judge
