#pragma once

#include "grader/judge/tool_folder.h"
#include "grader/process/run_command.h"
#include "grader/sandbox/box.h"

#include <cstdint>
#include <string>

namespace grader::judge {

// A run of a compiler or a linker in its box. Its output may contain text of a submission (#line "bwrap: x"),
// so the other two are known from the launcher and the kernel alone.
struct ToolRun {
  process::CommandResult result;
  bool started = false;  // the box was made, and the program began
  // SIGKILL ended it, or a part of it that report_parts() knows, before its time was over.
  bool killed = false;
};

// The address space of each part of a tool, the same on every machine: a verdict does not depend on where it was
// found. Nearly twice what g++ and clang need for all of the standard library, and less than the smallest machines have
// (Gradescope: 768 MiB), where the kernel would end a compiler before its limit does.
inline constexpr std::uint64_t kToolMemory = std::uint64_t{576} << 20;

// Runs the tool for at most `seconds`. Sets the first descriptors of the box. Tools that run side by side, for any
// judge with this folder, may need more memory than there is, and the kernel may kill the wrong one. So a tool that was
// killed runs once more, while no other tool runs.
ToolRun run_tool(const sandbox::Box& box, sandbox::Tier tier, int seconds,
                 const std::string& folder);

// The command is gcc's driver: how its parts (cc1plus, as) end is told to run_tool(). Other compilers
// are one process. To be called before words are added to the command.
void report_parts(sandbox::Box& box, const ToolFolder& place);

}  // namespace grader::judge
