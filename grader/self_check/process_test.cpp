// The judge's own processes.
#include "grader/process/run_command.h"
#include "tests/temporary_folder.h"

#include <chrono>
#include <filesystem>
#include <stop_token>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::self_check {
namespace {

// No child of this process waits to be asked how it ended.
bool all_are_asked() {
  siginfo_t ended{};
  return waitid(P_ALL, 0, &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid == 0;
}

void run(const char* script) {
  process::run_command({{"/bin/sh", "-c", script}, {"PATH=/usr/bin:/bin"}, {}, "", {}},
                       std::chrono::seconds(60));
}

// In containers nobody else asks.
TEST(orphans, are_asked_how_they_ended_whatever_their_session_and_group) {
  for (int i = 0; i < 5; ++i) {
    run("sleep 100 >/dev/null 2>&1 &");                   // killed with its group
    run("sleep 100 >/dev/null 2>&1 & setsid sleep 0 &");  // before one of its own session
  }
  for (int i = 0; i < 500 && !all_are_asked(); ++i) {
    usleep(10000);
    run("exit");
  }
  EXPECT_TRUE(all_are_asked());
}

TEST(command, ends_where_somebody_asks_it_to_stop) {
  const TemporaryFolder folder;
  const std::string at_its_end = folder.path() + "/reached";
  const std::string script = "sleep 30; touch " + at_its_end;
  std::stop_source source;
  std::jthread later([&] {
    usleep(100000);
    source.request_stop();
  });
  for (const char* when : {"while it runs", "before it runs"}) {
    EXPECT_THROW(
        process::run_command({{"/bin/sh", "-c", script}, {"PATH=/usr/bin:/bin"}, {}, "", {}},
                             std::chrono::seconds(600), source.get_token()),
        process::Stopped)
        << when;
    EXPECT_FALSE(std::filesystem::exists(at_its_end)) << when;
  }
  EXPECT_TRUE(all_are_asked());
}

}  // namespace
}  // namespace grader::self_check
