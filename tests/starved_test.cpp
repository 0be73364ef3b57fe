// A limit of time counts what a process had, not what others took from it.
#include "grader/process/starved.h"

#include <chrono>
#include <csignal>
#include <vector>

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

// Children that all run on the same processor, so that they take it from each other.
class Crowd {
 public:
  Crowd() {
    cpu_set_t allowed;
    sched_getaffinity(0, sizeof allowed, &allowed);
    for (int i = 0; i < CPU_SETSIZE && CPU_COUNT(&one_) == 0; ++i) {
      if (CPU_ISSET(i, &allowed)) CPU_SET(i, &one_);
    }
  }
  ~Crowd() {
    for (const pid_t each : all_) kill(each, SIGKILL);
    while (waitpid(-1, nullptr, 0) > 0) {
    }
  }
  template <class Work>
  pid_t add(Work work) {
    const pid_t child = fork();
    if (child == 0) {
      sched_setaffinity(0, sizeof one_, &one_);
      work();
      _exit(0);
    }
    all_.push_back(child);
    return child;
  }

 private:
  cpu_set_t one_{};
  std::vector<pid_t> all_;
};

void spin() {
  volatile bool more = true;
  while (more) {
  }
}

void wait_for_ever() {
  while (true) pause();
}

TEST(starved, counts_what_others_took_and_not_what_was_slept) {
  Crowd crowd;
  const pid_t sleeper = crowd.add(wait_for_ever);
  kill(sleeper, SIGSTOP);
  ASSERT_EQ(waitpid(sleeper, nullptr, WUNTRACED), sleeper);
  const nanoseconds before = starved(sleeper);
  const auto start = std::chrono::steady_clock::now();
  const pid_t family = crowd.add([] {
    if (fork() == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      spin();
    }
    wait_for_ever();
  });
  for (int i = 0; i < 3; ++i) crowd.add(spin);
  while (starved(family) < milliseconds(200)) {
    if (std::chrono::steady_clock::now() - start > std::chrono::seconds(20)) {
      GTEST_SKIP() << "this kernel does not tell how long a process waits for a processor";
    }
    usleep(10000);
  }
  EXPECT_LT(starved(family), std::chrono::steady_clock::now() - start);
  EXPECT_EQ(starved(sleeper), before);
}

TEST(starved, is_nothing_for_a_process_that_is_not_there) {
  EXPECT_EQ(starved(-5), nanoseconds(0));
}

}  // namespace
}  // namespace grader
