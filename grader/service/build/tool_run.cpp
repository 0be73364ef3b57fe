#include "grader/service/build/tool_run.h"

#include "grader/service/sandbox/launcher_messages.h"

#include <cerrno>
#include <csignal>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/wait.h>

namespace grader::build {

namespace {

namespace fs = std::filesystem;

// The box's descriptor for reports on how the tool's parts end (run_tool_part in main.cpp).
constexpr int kParts = 3;

// gcc splits the command of its wrapper at commas, and a folder's name may contain commas.
constexpr const char* kLauncher = "./launcher";

constexpr int kNotFound = 127;

// Returns whether a failed tool has lost a part: some part began, and none failed by itself. Then
// something killed a part, or the program that watched it.
bool lost_a_part(const base::Descriptor& parts) {
  bool begun = false, failed = false;
  for (char byte = 0; read(parts.number(), &byte, 1) == 1;) {
    begun = begun || byte == 'b';
    failed = failed || byte == 'f';
  }
  return begun && !failed;
}

// Holds a lock in the folder, together with others (LOCK_SH) or alone (LOCK_EX), until the
// descriptor is closed. If the disk is full, nobody waits.
base::Descriptor lock(const std::string& folder, int how) {
  base::Descriptor file(
      open((folder + "/running_tools").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  while (file.is_open() && flock(file.number(), how) != 0 && errno == EINTR) {
  }
  return file;
}

ToolRun run_once(sandbox::Box box, sandbox::Tier tier, int seconds) {
  const base::Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  const base::Pipe parts = base::make_pipe(), launcher = base::make_pipe();
  base::set_nonblocking(parts.read_end);
  base::set_nonblocking(launcher.read_end);
  box.descriptors = {nothing.number(), nothing.number(), nothing.number(), parts.write_end.number(),
                     launcher.write_end.number()};
  box.tells_start = true;
  ToolRun run;
  run.result = process::run_command(sandbox::boxed(box, tier), std::chrono::seconds(seconds));
  sandbox::LauncherMessages messages;
  messages.listen(launcher.read_end);
  int& status = run.result.status;
  status = sandbox::program_status(status, tier, messages);
  run.started = tier == sandbox::Tier::limits
                    ? !(WIFEXITED(status) && WEXITSTATUS(status) == kNotFound)
                    : messages.has_started();
  const bool ended = (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) ||
                     (!run.result.ok() && lost_a_part(parts.read_end));
  // Its own time limit ends the tool with the same signal.
  if (ended && run.result.seconds >= 0.9 * seconds) run.result.timed_out = true;
  run.killed = ended && !run.result.timed_out;
  return run;
}

}  // namespace

void report_parts(sandbox::Box& box, const ToolFolder& place) {
  const std::string launcher = sandbox::launcher_path();
  if (!fs::exists(launcher)) return;
  fs::create_symlink(launcher, fs::path(place.folder()) / kLauncher);
  box.visible.push_back(launcher);
  box.command.insert(box.command.end(),
                     {"-wrapper", fmt::format("{},--part={},--", kLauncher, kParts)});
}

ToolRun run_tool(const sandbox::Box& box, sandbox::Tier tier, int seconds,
                 const std::string& folder) {
  {
    const base::Descriptor running = lock(folder, LOCK_SH);
    ToolRun run = run_once(box, tier, seconds);
    if (!run.killed) return run;
  }
  const base::Descriptor alone = lock(folder, LOCK_EX);
  return run_once(box, tier, seconds);
}

}  // namespace grader::build
