// The judge's own processes.
#include "grader/service/process/one_processor.h"
#include "grader/service/process/run_command.h"
#include "tests/fixtures/temporary_folder.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::tests {
namespace {

// This process has no zombies.
bool all_are_reaped() {
  siginfo_t ended{};
  return waitid(P_ALL, 0, &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid == 0;
}

void run(const char* script) {
  process::run_command({{"/bin/sh", "-c", script}, {"PATH=/usr/bin:/bin"}, {}, "", {}},
                       std::chrono::seconds(60));
}

// An orphan that has not ended yet is reaped after a later command.
bool are_reaped_by_the_next_commands() {
  for (int i = 0; i < 500 && !all_are_reaped(); ++i) {
    usleep(10000);
    run("exit");
  }
  return all_are_reaped();
}

// In a container, nobody else collects orphans.
TEST(orphans, are_reaped_whatever_their_session_and_group) {
  for (int i = 0; i < 5; ++i) {
    run("sleep 100 >/dev/null 2>&1 &");                   // killed with its group
    run("sleep 100 >/dev/null 2>&1 & setsid sleep 0 &");  // before one in its own session
  }
  EXPECT_TRUE(are_reaped_by_the_next_commands());
}

TEST(command, ends_where_somebody_asks_it_to_stop) {
  const TemporaryFolder folder;
  const std::string at_its_end = folder.path() + "/reached";
  const std::string script = "sleep 30; touch " + at_its_end;
  std::atomic<bool> stop = false;
  std::jthread later([&] {
    usleep(100000);
    stop = true;
  });
  for (const char* when : {"while it runs", "before it runs"}) {
    EXPECT_THROW(
        process::run_command({{"/bin/sh", "-c", script}, {"PATH=/usr/bin:/bin"}, {}, "", {}},
                             std::chrono::seconds(600), &stop),
        process::Stopped)
        << when;
    EXPECT_FALSE(std::filesystem::exists(at_its_end)) << when;
  }
  EXPECT_TRUE(are_reaped_by_the_next_commands());
}

// A process that does nothing until the end of the test.
class Sleeper {
 public:
  Sleeper() : pid_(fork()) {
    if (pid_ == 0) {
      while (true) pause();
    }
  }
  ~Sleeper() {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_;
};

cpu_set_t processors_of(pid_t pid) {
  cpu_set_t set;
  EXPECT_EQ(sched_getaffinity(pid, sizeof set, &set), 0);
  return set;
}

bool same(const cpu_set_t& a, const cpu_set_t& b) { return CPU_EQUAL(&a, &b); }

void expect_together(pid_t other) {
  const cpu_set_t own = processors_of(0);
  EXPECT_EQ(CPU_COUNT(&own), 1);
  EXPECT_TRUE(same(own, processors_of(other)));
}

void expect_free(pid_t other, const cpu_set_t& all) {
  EXPECT_TRUE(same(processors_of(0), all));
  EXPECT_TRUE(same(processors_of(other), all));
}

class one_processor : public testing::Test {
 protected:
  void SetUp() override {
    if (CPU_COUNT(&all_) < 2) GTEST_SKIP() << "there is one processor";
  }
  const cpu_set_t all_ = processors_of(0);
  const Sleeper other_;
};

TEST_F(one_processor, is_held_by_both_until_they_are_let_go) {
  process::OneProcessor one;
  expect_free(other_.pid(), all_);
  one.hold(other_.pid());
  expect_together(other_.pid());
  one.let_go();
  expect_free(other_.pid(), all_);
}

// Otherwise two pairs that began on one processor would stay there.
TEST_F(one_processor, is_chosen_anew_after_each_turn) {
  process::OneProcessor one;
  for (int i = 0; i < 3; ++i) {
    one.hold(other_.pid());
    expect_together(other_.pid());
    std::this_thread::sleep_for(2 * process::OneProcessor::kTurn);
    one.hold(other_.pid());
    expect_free(other_.pid(), all_);
  }
}

TEST_F(one_processor, is_not_held_any_more_after_its_end_or_for_another_process) {
  const Sleeper next;
  {
    process::OneProcessor one;
    one.hold(other_.pid());
    one.hold(next.pid());
    expect_together(next.pid());
    EXPECT_TRUE(same(processors_of(other_.pid()), all_));
  }
  expect_free(next.pid(), all_);
}

// This thread stays free if the other process is unknown, or has ended before or meanwhile.
TEST_F(one_processor, is_nobodys_without_another_process) {
  process::OneProcessor one;
  one.hold(-1);
  EXPECT_TRUE(same(processors_of(0), all_));
  pid_t gone = 0;
  {
    const Sleeper sleeper;
    gone = sleeper.pid();
    one.hold(gone);
    expect_together(gone);
  }
  one.let_go();
  EXPECT_TRUE(same(processors_of(0), all_));
  process::OneProcessor late;
  late.hold(gone);
  EXPECT_TRUE(same(processors_of(0), all_));
}

}  // namespace
}  // namespace grader::tests
