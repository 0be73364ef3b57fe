#include "grader/judge/tool_run.h"

#include "grader/sandbox/told.h"

#include <csignal>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>

namespace grader::judge {

namespace {

namespace fs = std::filesystem;

// Under which the box has the write end for parts that were killed.
constexpr int kKilled = 3;

// gcc splits the command of its wrapper at commas, which a folder's name may have.
constexpr const char* kLauncher = "./launcher";

constexpr int kNotFound = 127;

}  // namespace

void report_killed_parts(sandbox::Box& box, const ToolFolder& place) {
  const std::string launcher = sandbox::launcher_path();
  if (!fs::exists(launcher)) return;
  fs::create_symlink(launcher, fs::path(place.folder()) / kLauncher);
  box.visible.push_back(launcher);
  box.command.insert(box.command.end(),
                     {"-wrapper", fmt::format("{},--killed={},--", kLauncher, kKilled)});
}

ToolRun run_tool(sandbox::Box box, sandbox::Tier tier, int seconds) {
  const base::Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  const base::Pipe killed = base::make_pipe(), launcher = base::make_pipe();
  base::set_nonblocking(killed.read_end);
  base::set_nonblocking(launcher.read_end);
  box.descriptors = {nothing.number(), nothing.number(), nothing.number(),
                     killed.write_end.number(), launcher.write_end.number()};
  box.tells_start = true;
  ToolRun run;
  run.result = process::run_command(sandbox::boxed(box, tier), std::chrono::seconds(seconds));
  sandbox::Told told;
  told.listen(launcher.read_end);
  int& status = run.result.status;
  status = sandbox::program_status(status, tier, told);
  run.started = tier == sandbox::Tier::limits
                    ? !(WIFEXITED(status) && WEXITSTATUS(status) == kNotFound)
                    : told.has_started();
  char byte = 0;
  run.killed = (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) ||
               read(killed.read_end.number(), &byte, 1) == 1;
  return run;
}

}  // namespace grader::judge
