#include "grader/service/process/linux_calls.h"

#include "grader/service/process/spawn.h"

#include <csignal>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::process {

namespace {

// A process started by spawn() leads a group in our session. Keepers of boxes
// (grader/service/sandbox) have left the session; leftovers of a compiler are in its group.
bool is_orphan(pid_t pid) { return getsid(pid) != getsid(0) || getpgid(pid) != pid; }

}  // namespace

void stay_with_parent() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
}

void close_from(int first) { close_range(static_cast<unsigned>(first), ~0U, 0); }

// The first process of a container may never ask for the status of orphans, so that hundreds of dead processes would pile up.
void reap_orphans() {
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  siginfo_t ended{};
  while (waitid(P_ALL, 0, &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid != 0 &&
         is_orphan(ended.si_pid)) {
    waitpid(ended.si_pid, nullptr, WNOHANG);
    ended = {};
  }
}

void hide_process() {
  if (!kSanitized) prctl(PR_SET_DUMPABLE, 0);
}

}  // namespace grader::process
