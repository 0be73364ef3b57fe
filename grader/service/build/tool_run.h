#pragma once

#include "grader/service/build/tool_folder.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/box.h"

#include <cstdint>
#include <string>

namespace grader::build {

// A run of a compiler or a linker in its box. Its output may contain text of a submission (#line
// "bwrap: x"), so the other two members come from the launcher and the kernel alone.
struct ToolRun {
  process::CommandResult result;
  bool started = false;  // the box was made, and the program began
  // SIGKILL ended it, or a part reported through report_parts(), before its time was over.
  bool killed = false;
};

// The address space of each part of a tool. It is the same everywhere, so that a verdict does not
// depend on the machine: nearly twice what g++ and clang need for all of the standard library, but
// less than the smallest machines have (Gradescope: 768 MiB).
inline constexpr std::uint64_t kToolMemory = std::uint64_t{576} << 20;

// Runs the tool for at most `seconds`. Sets the first descriptors of the box. All tools that run at
// once with this folder, for any judge, may need more memory than there is, and the kernel may kill
// the wrong tool. So a tool that was killed runs once more, while no other tool runs.
ToolRun run_tool(const sandbox::Box& box, sandbox::Tier tier, int seconds,
                 const std::string& folder);

// Makes gcc's driver report to run_tool() how its parts (cc1plus, as) end. Other compilers are one
// process. Call this before words are added to the command.
void report_parts(sandbox::Box& box, const ToolFolder& place);

}  // namespace grader::build
