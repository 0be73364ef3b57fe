// box: restricts itself, and then becomes the program of the box, with access to the visible files
// only. grader/service/sandbox/box.cpp writes the command line. No code of a submission runs before
// the last line. It also runs between a compiler and its parts (run_tool_part).
#include "grader/service/sandbox/launcher/filter.h"
#include "grader/service/sandbox/launcher/landlock.h"
#include "grader/service/sandbox/launcher/options.h"
#include "grader/service/sandbox/launcher/user.h"
#include "pt/error.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::sandbox::box {

namespace {

// Runs a part of a tool that is already in a box, for a compiler's driver (gcc, -wrapper), and
// returns its exit status. The driver only prints how a part ended, mixed with text that may be the
// submission's. So this writes to the descriptor `parts`, which the part does not get: 'b' before
// the part begins, 'f' if it failed by itself (not if SIGKILL ended it or this program).
int run_tool_part(const std::vector<char*>& command, int parts) {
  fcntl(parts, F_SETFD, FD_CLOEXEC);
  const auto tell = [&](const char* byte) {
    if (write(parts, byte, 1) != 1) throw pt::Error("nobody listens to the parts of a tool");
  };
  tell("b");
  const pid_t part = fork();
  if (part < 0) throw pt::Error(std::string("no process: ") + std::strerror(errno));
  if (part == 0) {
    execvp(command[0], command.data());
    _exit(127);
  }
  int status = 0;
  while (waitpid(part, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFSIGNALED(status)) {
    if (WEXITSTATUS(status) != 0) tell("f");
    return WEXITSTATUS(status);
  }
  const int signal = WTERMSIG(status);
  if (signal != SIGKILL) tell("f");
  if (signal == SIGXFSZ) {
    std::fprintf(
        stderr, "%s: error: its output is too large; is there a huge array that is not all zero?\n",
        command[0]);
  } else {
    std::fprintf(stderr, "%s: error: it ended with signal %d (%s)\n", command[0], signal,
                 strsignal(signal));
  }
  return 128 + signal;
}

}  // namespace

}  // namespace grader::sandbox::box

namespace {

using namespace grader;
using namespace grader::sandbox::box;

constexpr int kMaxFiles = 512;
constexpr int kProgramNumber = 800;
static_assert(kProgramNumber > kMaxFiles, "a program could start another one under this number");

[[noreturn]] void fail(const std::string& what) {
  throw pt::Error(what + ": " + std::strerror(errno));
}

// The program's file gets a number above the limit for the program's own descriptors: the filter
// allows a start through this number only.
base::Descriptor open_program(const char* path) {
  rlimit files{};
  if (getrlimit(RLIMIT_NOFILE, &files) != 0) fail("limits");
  files.rlim_cur = files.rlim_max;
  setrlimit(RLIMIT_NOFILE, &files);
  const base::Descriptor found(open(path, O_PATH | O_CLOEXEC));
  if (!found.is_open()) fail(path);
  base::Descriptor program(fcntl(found.number(), F_DUPFD_CLOEXEC, kProgramNumber));
  if (!program.is_open()) fail(path);
  return program;
}

// A byte for the process that waits for the start. The program itself cannot write it.
void tell(int started) {
  if (started >= 0 && write(started, "s", 1) != 1) fail("the judge");
}

// Enters folders through descriptors: the other user may be unable to pass the folders above.
void enter(const std::string& folder, const std::optional<User>& user) {
  if (folder.empty()) {
    if (chdir("/") != 0) fail("/");
    return;
  }
  const base::Descriptor place(open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!place.is_open() || fchdir(place.number()) != 0) fail(folder);
  if (user && fchownat(place.number(), "", user->id, user->id, AT_EMPTY_PATH) != 0) fail(folder);
}

[[noreturn]] void run(Options options) {
  if (options.inside) continue_as_child(options.started);
  if (options.started >= 0) fcntl(options.started, F_SETFD, FD_CLOEXEC);
  const base::Descriptor program = open_program(options.command[0]);
  const base::Descriptor rules = file_rules(options);

  std::optional<User> user;
  if (options.inside) {
    if (options.user != 0) user = User{options.user, {}};
  } else {
    if (geteuid() == 0) user = take_any_user();
    start_keeper(user);
  }
  enter(options.folder, user);
  if (user) become(*user);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  enforce(rules);
  // A user's processes are counted together, so a limit only makes sense for a user without others.
  if (!user && options.limits.processes != 0) options.limits.processes.reset();
  if (options.limits.open_files.value_or(kMaxFiles) > std::uint64_t{kMaxFiles}) {
    throw pt::Error("a program in a box may have at most 512 open files");
  }
  if (!options.limits.open_files) options.limits.open_files = kMaxFiles;
  if (!process::set_limits(options.limits)) fail("limits");
  filter_system_calls(program.number(), options.tools);
  tell(options.started);
  syscall(SYS_execveat, program.number(), "", options.command.data(), environ, AT_EMPTY_PATH);
  tell(options.started);
  fail(options.command[0]);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Options options = parse(argc, argv);
    if (options.part >= 0) return run_tool_part(options.command, options.part);
    run(options);
  } catch (const pt::Error& error) {
    std::fprintf(stderr, "box: %s\n", error.what());
    return 127;
  }
}
