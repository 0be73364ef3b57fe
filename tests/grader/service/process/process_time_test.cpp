// A time limit counts the time that a process had, not the time that others took from it.
#include "grader/service/process/process_time.h"

#include "grader/service/process/time_limit.h"
#include "pt/error.h"

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::process {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

// Children that all run on one processor, so that they take time from each other.
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
  // Adds a child that is stopped: its processor time, spent on the fork, grows no more.
  pid_t add_stopped() {
    const pid_t child = add([] { raise(SIGSTOP); });
    EXPECT_EQ(waitpid(child, nullptr, WUNTRACED), child);
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

TEST(process_time, counts_what_others_took_and_not_what_was_slept) {
  Crowd crowd;
  const pid_t sleeper = crowd.add_stopped();
  const nanoseconds before = time_of_tree(sleeper).waiting;
  const auto start = std::chrono::steady_clock::now();
  const pid_t family = crowd.add([] {
    if (fork() == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      spin();
    }
    wait_for_ever();
  });
  for (int i = 0; i < 3; ++i) crowd.add(spin);
  while (time_of_tree(family).waiting < milliseconds(200)) {
    if (std::chrono::steady_clock::now() - start > std::chrono::seconds(20)) {
      GTEST_SKIP() << "this kernel does not tell how long a process waits for a processor";
    }
    usleep(10000);
  }
  EXPECT_LT(time_of_tree(family).waiting, 2 * (std::chrono::steady_clock::now() - start))
      << "of two processes";
  EXPECT_EQ(time_of_tree(sleeper).waiting, before);
}

TEST(process_time, is_nothing_for_a_process_that_is_not_there) {
  EXPECT_EQ(time_of_tree(-5).waiting, nanoseconds(0));
}

// Results on a busy machine, where the child and others share one processor.
struct Looks {
  bool over = false;
  int count = 0;
  nanoseconds running{0};
};

// Looks until the limit is over or the child has run twice as long.
Looks look(pid_t child, milliseconds limit) {
  TimeLimit time(child, limit);
  Looks looks;
  while (!looks.over && looks.running < 2 * limit) {
    const Wait wait;
    // Sleeps once, like the judge: after each sleep, a process has to wait for a processor again.
    std::this_thread::sleep_until(time.next_look());
    time.add_waited(wait.net(limit));
    looks.running = time_of_tree(child).running;
    looks.over = time.is_over();
    ++looks.count;
  }
  return looks;
}

TEST(time_limit, counts_what_was_computed_beside_others) {
  Crowd crowd;
  for (int i = 0; i < 6; ++i) crowd.add(spin);
  const pid_t child = crowd.add(spin);
  const auto start = TimeLimit::Clock::now();
  const Looks looks = look(child, milliseconds(200));
  EXPECT_TRUE(looks.over);
  EXPECT_GE(time_of_tree(child).running, milliseconds(200));
  EXPECT_GT(looks.count, 1) << "by the clock it would have been over at the first look";
  EXPECT_GT(TimeLimit::Clock::now() - start, milliseconds(400));
}

TEST(time_limit, ends_what_sleeps) {
  Crowd crowd;
  for (int i = 0; i < 6; ++i) crowd.add(spin);
  const pid_t child = crowd.add(wait_for_ever);
  EXPECT_TRUE(look(child, milliseconds(50)).over);
  EXPECT_LT(time_of_tree(child).running, milliseconds(50));
}

// Nobody has waited for the child here, so the limit does not count sleep: it had no processor.
TEST(time_limit, says_that_the_machine_is_too_busy_and_not_that_the_program_is_too_slow) {
  Crowd crowd;
  const pid_t child = crowd.add_stopped();
  TimeLimit time(child, milliseconds(2), time_of_tree(child).running);
  const auto start = TimeLimit::Clock::now();
  bool over = false;
  std::string said;
  while (said.empty() && !over && TimeLimit::Clock::now() - start < std::chrono::seconds(30)) {
    usleep(1000);
    if (TimeLimit::Clock::now() < time.next_look()) continue;
    try {
      over = time.is_over();
    } catch (const pt::Error& error) {
      said = error.what();
    }
  }
  EXPECT_FALSE(over);
  EXPECT_NE(said.find("the machine is too busy"), std::string::npos) << said;
  EXPECT_GE(TimeLimit::Clock::now() - start, TimeLimit::kMaxByClock * milliseconds(2));
}

TEST(time_limit, is_not_about_the_machine_before_its_time) {
  EXPECT_NO_THROW(expect_processor(milliseconds(1), milliseconds(10), milliseconds(10)));
  EXPECT_THROW(expect_processor(milliseconds(1), milliseconds(11), milliseconds(10)), pt::Error);
}

// Waits for the child and looks, like a judge, until it has slept for `enough` or `most` is over.
nanoseconds watch(SleepWatch& sleep, pid_t child, milliseconds enough, milliseconds most) {
  const auto start = TimeLimit::Clock::now();
  while (sleep.slept() < enough && TimeLimit::Clock::now() - start < most) {
    const Wait wait;
    const auto pause = std::chrono::ceil<milliseconds>(sleep.until_look());
    usleep(static_cast<useconds_t>(1000 * pause.count()));
    sleep.add_waited(wait.net(pause));
    sleep.look(child);
  }
  return TimeLimit::Clock::now() - start;
}

TEST(sleep_watch, finds_a_sleep_before_its_end) {
  if (!time_of_process(getppid()).asleep && !time_of_process(1).asleep) {
    GTEST_SKIP() << "this kernel does not tell how long a process waits for a processor";
  }
  Crowd crowd;
  for (int i = 0; i < 6; ++i) crowd.add(spin);
  SleepWatch sleep;
  const nanoseconds took =
      watch(sleep, crowd.add(wait_for_ever), milliseconds(300), std::chrono::seconds(20));
  EXPECT_GE(sleep.slept(), milliseconds(300));
  EXPECT_LE(sleep.slept(), took);
}

// The child still waits for a processor during the look, and the kernel does not count that yet.
TEST(sleep_watch, takes_no_wait_for_a_processor_for_sleep) {
  Crowd crowd;
  for (int i = 0; i < 6; ++i) crowd.add(spin);
  SleepWatch sleep;
  watch(sleep, crowd.add(spin), milliseconds(1), milliseconds(400));
  EXPECT_EQ(sleep.slept(), nanoseconds(0));
}

// Time in which the child ran, or others took from it, is not sleep.
TEST(sleep_watch, counts_no_more_than_is_left_of_the_time) {
  Crowd crowd;
  for (int i = 0; i < 3; ++i) crowd.add(spin);
  const auto start = TimeLimit::Clock::now();
  const pid_t child = crowd.add([] {
    while (true) {
      const nanoseconds end = running_time(getpid()) + milliseconds(3);
      while (running_time(getpid()) < end) {
      }
      usleep(3000);
    }
  });
  SleepWatch sleep;
  watch(sleep, child, std::chrono::hours(1), milliseconds(800));
  const ProcessTime time = time_of_process(child);
  const nanoseconds whole = TimeLimit::Clock::now() - start;
  EXPECT_LE(sleep.slept(), whole - time.running - time.waiting + milliseconds(1));
}

TEST(sleep_watch, counts_nothing_of_a_program_that_has_not_begun) {
  SleepWatch sleep;
  for (int i = 0; i < 5; ++i) {
    sleep.add_waited(milliseconds(100));
    sleep.look(-1);
  }
  EXPECT_EQ(sleep.slept(), nanoseconds(0));
}

// A compiler starts other programs that do the work.
TEST(process_time, counts_children_that_have_ended) {
  const nanoseconds before = time_of_tree(getpid()).running;
  for (int i = 0; i < 5; ++i) {
    if (fork() == 0) {
      const nanoseconds end = running_time(getpid()) + milliseconds(40);
      while (running_time(getpid()) < end) {
      }
      _exit(0);
    }
    wait(nullptr);
  }
  const nanoseconds ticks = milliseconds(2 * 5 * 10);  // a tick of each is not whole, twice
  EXPECT_GE(time_of_tree(getpid()).running - before, milliseconds(5 * 40) - ticks);
}

TEST(process_time, finds_who_does_the_work) {
  Crowd crowd;
  const pid_t family = crowd.add([] {
    if (fork() == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (fork() == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        spin();
      }
      wait_for_ever();
    }
    wait_for_ever();
  });
  pid_t last = family;
  for (int i = 0; i < 3000 && running_time(last) < milliseconds(30); ++i) {
    usleep(1000);
    last = last_descendant(family);
  }
  EXPECT_GE(running_time(last), milliseconds(30));
  EXPECT_LT(running_time(family), milliseconds(30));
}

}  // namespace
}  // namespace grader::process
