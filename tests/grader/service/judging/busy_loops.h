#pragma once

#include "pt/error.h"

#include <atomic>
#include <csignal>
#include <vector>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::tests {

// Endless loops in their own processes, which take processor time from all others. They end with
// this object or with the program.
class BusyLoops {
 public:
  explicit BusyLoops(int count) {
    for (int i = 0; i < count; ++i) {
      const pid_t pid = fork();
      if (pid < 0) throw pt::Error("busy loops cannot be started here; ask for fewer");
      if (pid == 0) loop();
      pids_.push_back(pid);
    }
  }
  ~BusyLoops() {
    for (const pid_t pid : pids_) {
      kill(pid, SIGKILL);
      waitpid(pid, nullptr, 0);
    }
  }
  BusyLoops(const BusyLoops&) = delete;
  BusyLoops& operator=(const BusyLoops&) = delete;

 private:
  [[noreturn]] static void loop() {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (std::atomic<unsigned> turns = 0;; ++turns) {
    }
  }

  std::vector<pid_t> pids_;
};

}  // namespace grader::tests
