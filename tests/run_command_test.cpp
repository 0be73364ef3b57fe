// A command's limit of time, whatever it prints meanwhile.
#include "grader/process/run_command.h"

#include <chrono>
#include <string>

#include <gtest/gtest.h>

namespace grader::process {
namespace {

using std::chrono::milliseconds;

// The limit of the kernel ends what the limit of time does not.
CommandResult run_script(const std::string& script, milliseconds most) {
  Child child{{"/bin/sh", "-c", script}, {"PATH=/usr/bin:/bin"}, {}, "", {}};
  child.limits.cpu_seconds = 5;
  return run_command(child, most);
}

TEST(CommandLimit, ends_what_prints_without_end) {
  const CommandResult endless = run_script("while :; do echo more; done", milliseconds(300));
  EXPECT_TRUE(endless.timed_out);
  EXPECT_EQ(endless.output.substr(0, 5), "more\n");
  EXPECT_TRUE(run_script("exec yes", milliseconds(300)).timed_out);
}

TEST(CommandLimit, ends_what_prints_slowly_without_end) {
  const CommandResult slow = run_script("while :; do echo x; sleep 0.02; done", milliseconds(100));
  EXPECT_TRUE(slow.timed_out);
  EXPECT_EQ(slow.output.substr(0, 2), "x\n");
}

TEST(CommandLimit, leaves_alone_what_prints_slowly_and_ends) {
  const CommandResult slow =
      run_script("for i in 1 2 3 4 5; do echo $i; sleep 0.02; done", milliseconds(10000));
  EXPECT_TRUE(slow.ok());
  EXPECT_EQ(slow.output, "1\n2\n3\n4\n5\n");
}

}  // namespace
}  // namespace grader::process
