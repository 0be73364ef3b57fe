#include "grader/service/sandbox/launcher/tool_part.h"

#include "pt/error.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::sandbox::box {

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

}  // namespace grader::sandbox::box
