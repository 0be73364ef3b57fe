// The system-call filter of docs/decisions/0020, with each call in its own process.
#include "grader/service/sandbox/launcher/filter.h"

#include "grader/service/process/limits.h"

#include <cerrno>
#include <csignal>
#include <ostream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::sandbox::box {
namespace {

constexpr int kProgram = 800;

enum class End { works, fails, killed };
std::ostream& operator<<(std::ostream& out, End end) {
  return out << (end == End::works ? "works" : end == End::fails ? "EPERM" : "killed");
}

struct Call {
  std::string name;
  long number;
  std::vector<long> arguments = {};
};

// Only EPERM counts as refused: this is the filter's answer; all others come from the kernel.
End end_of(const Call& call, bool tools) {
  const pid_t child = fork();
  if (child == 0) {
    std::vector<long> a = call.arguments;
    a.resize(6);

    // An exception ends the child: it must not go on with the tests.
    [tools]() noexcept { filter_system_calls(kProgram, tools); }();
    errno = 0;
    syscall(call.number, a[0], a[1], a[2], a[3], a[4], a[5]);
    _exit(errno == EPERM ? 1 : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) {
    EXPECT_EQ(WTERMSIG(status), SIGSYS) << call.name;
    return End::killed;
  }
  return WEXITSTATUS(status) == 0 ? End::works : End::fails;
}

void expect_all(const std::vector<Call>& calls, End worker, End tool) {
#if FIRSTLIGHT_SECCOMP
  if (process::kSanitized) GTEST_SKIP() << "NOT TESTED: a sanitised program needs more calls";
  for (const Call& call : calls) {
    EXPECT_EQ(end_of(call, false), worker) << call.name;
    EXPECT_EQ(end_of(call, true), tool) << call.name << " of a compiler";
  }
#else
  GTEST_SKIP() << "NOT TESTED: libseccomp is missing";
#endif
}

const long kHere = reinterpret_cast<long>(".");
constexpr long kHigh = 1L << 40;  // the kernel ignores this bit of an int

TEST(Filter, lets_through_what_programs_need) {
  expect_all({{"write", SYS_write, {1}},
              {"fcntl F_GETFL", SYS_fcntl, {0, F_GETFL}},
              {"fcntl F_SETFL", SYS_fcntl, {0, F_SETFL, O_NONBLOCK}},
              {"isatty", SYS_ioctl, {0, TCGETS}},
              {"openat to read", SYS_openat, {AT_FDCWD, kHere, O_RDONLY | O_DIRECTORY}},
              {"own limits", SYS_prlimit64, {0}},
              {"the program", SYS_execveat, {kProgram, kHere, 0, 0, AT_EMPTY_PATH}}},
             End::works, End::works);
}

TEST(Filter, lets_through_what_compilers_need_alone) {
  expect_all({{"openat to write", SYS_openat, {AT_FDCWD, kHere, O_WRONLY}},
              {"unlinkat", SYS_unlinkat, {AT_FDCWD}},
              {"wait4", SYS_wait4, {-1, 0, WNOHANG}}},
             End::fails, End::works);
  expect_all({{"execve", SYS_execve}}, End::killed, End::works);
}

// Honest programs try these calls and continue without them.
TEST(Filter, says_no_to_what_libraries_try) {
  expect_all({{"socket", SYS_socket, {1, 1}},
              {"prctl", SYS_prctl, {15}},
              {"fcntl F_GETLK", SYS_fcntl, {0, F_GETLK}},
              {"ioctl FIONREAD", SYS_ioctl, {0, FIONREAD}},
              {"sched_setaffinity", SYS_sched_setaffinity},
              {"the next call that a kernel gets", 5000}},
             End::fails, End::fails);
}

TEST(Filter, ends_attacks) {
  expect_all({{"ptrace", SYS_ptrace},
              {"process_vm_readv", SYS_process_vm_readv},
              {"unshare", SYS_unshare},
              {"clone, a new user namespace", SYS_clone, {CLONE_NEWUSER}},
              {"mount", SYS_mount},
              {"bpf", SYS_bpf},
              {"keyctl", SYS_keyctl},
              {"io_uring_setup", SYS_io_uring_setup},
              {"setuid", SYS_setuid},
              {"limits of process 1", SYS_prlimit64, {1}},
              {"another program", SYS_execveat, {kProgram - 1, kHere, 0, 0, AT_EMPTY_PATH}},
              {"openat O_ASYNC", SYS_openat, {AT_FDCWD, kHere, O_ASYNC}},
              {"openat O_DIRECT", SYS_openat, {AT_FDCWD, kHere, O_DIRECT}},
              {"fcntl F_SETOWN", SYS_fcntl, {0, F_SETOWN}},
              {"fcntl F_SETOWN, high bits", SYS_fcntl, {0, F_SETOWN | kHigh}},
              {"fcntl O_ASYNC", SYS_fcntl, {0, F_SETFL, O_ASYNC}},
              {"ioctl FIOASYNC", SYS_ioctl, {0, FIOASYNC | kHigh}},
              {"ioctl TIOCSTI", SYS_ioctl, {0, TIOCSTI}}},
             End::killed, End::killed);
}

TEST(Filter, ends_what_only_a_worker_would_attack_with) {
  expect_all({{"kill", SYS_kill, {1}},
              {"tgkill", SYS_tgkill, {1}},
              {"setsid", SYS_setsid},
              {"personality", SYS_personality, {0xffffffff}},
              {"memfd_create", SYS_memfd_create, {kHere}},
              {"shmget", SYS_shmget}},
             End::killed, End::fails);
}

}  // namespace
}  // namespace grader::sandbox::box
