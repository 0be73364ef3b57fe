// Commands from start to end: their time limit, whatever they print, and their descriptors.
#include "grader/service/process/run_command.h"

#include "grader/base/descriptor.h"
#include "grader/service/process/cause_of_end.h"
#include "grader/service/process/spawn.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::process {
namespace {

using std::chrono::milliseconds;

// The kernel's limit ends programs that the time limit misses.
CommandResult run_script(const std::string& script, milliseconds most) {
  Child child{{"/bin/sh", "-c", script}, {"PATH=/usr/bin:/bin"}, {}, "", {}};
  child.limits.cpu_seconds = 5;
  return run_command(child, most);
}

// A machine without memory kills any process, so a killed command is tried again. The sentence of a picture says
// more than the cause.
TEST(CauseOfEnd, tells_what_was_killed_from_outside) {
  const auto signal = [](const std::string& name) {
    const int status = run_script("kill -s " + name + " $$", std::chrono::seconds(30)).status;
    return was_killed("in the first row, " + cause_of_end(status, "") + " in it");
  };
  EXPECT_TRUE(signal("KILL"));
  for (const char* other : {"SEGV", "ABRT", "FPE", "XCPU"}) EXPECT_FALSE(signal(other)) << other;
}

TEST(CauseOfEnd, is_what_the_program_printed_before_it_aborted) {
  const auto said = [](const std::string& words) { return cause_of_end(SIGABRT, words); };
  EXPECT_EQ(said(""), "it called abort()");
  EXPECT_EQ(said("terminate called after throwing an instance of 'E'\n  what():  too far\n"),
            "terminate called after throwing an instance of 'E'; what():  too far");
  EXPECT_EQ(said("  what():  of an earlier one\n"), "it called abort()");
  EXPECT_EQ(said("worker: hit_box.cpp:12: bool pt::f(): Assertion `x > 0' failed.\n"),
            "Assertion `x > 0' failed. (line 12)");
  EXPECT_EQ(said("/usr/include/optional:477: f(): Assertion 'this->_M_is_engaged()' failed.\n"),
            "the value of an empty std::optional was read (--from student --sanitize names the "
            "line)");
  EXPECT_EQ(said("vector:1: Assertion '__n < this->size()' failed.\n"),
            "an index is not below the size of its std::vector, std::array or std::span (--from "
            "student --sanitize names the line)");
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

// Opens a file in memory with this text under this descriptor number, and closes any older one.
base::Descriptor file_at(int number, const std::string& text) {
  base::Descriptor any(memfd_create("text", MFD_CLOEXEC));
  const base::Descriptor far(fcntl(any.number(), F_DUPFD_CLOEXEC, 900));
  any.close();  // it may have the wanted number
  EXPECT_EQ(pwrite(far.number(), text.data(), text.size(), 0), static_cast<ssize_t>(text.size()));
  EXPECT_EQ(dup2(far.number(), number), number);
  return base::Descriptor(number);
}

// Prints three files, with descriptors from `first` on. The child has them in the reverse order.
std::string printed_from(int first) {
  const base::Descriptor a = file_at(first, "a"), b = file_at(first + 1, "b"),
                         c = file_at(first + 2, "c"), out = file_at(first + 3, "");
  Child child{{"/bin/cat", "/dev/fd/3", "/dev/fd/4", "/dev/fd/5"}, {}, {}, "", {}};
  child.descriptors = {a.number(), out.number(), out.number(), c.number(), b.number(), a.number()};
  child.limits.cpu_seconds = 5;
  const pid_t pid = spawn(child);
  int status = 0;
  EXPECT_EQ(waitpid(pid, &status, 0), pid);
  std::string text(16, ' ');
  text.resize(std::max<ssize_t>(pread(out.number(), text.data(), text.size(), 0), 0));
  return text + " " + describe_status(status);
}

// The parent's descriptors may have any numbers, also the numbers that the child's will have.
TEST(Descriptors, become_those_of_the_child_whatever_their_numbers) {
  for (const int first : {3, 8, 20, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 250, 796, 800}) {
    EXPECT_EQ(printed_from(first), "cba exit status 0") << first;
  }
}

}  // namespace
}  // namespace grader::process
