#include "grader/sandbox/launcher/filter.h"

#include "pt/error.h"

#if FIRSTLIGHT_SECCOMP
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>

#include <asm/sockios.h>
#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <unistd.h>
#endif

namespace grader::sandbox::box {

#if FIRSTLIGHT_SECCOMP

namespace {

// Names, as machines differ in what they have. What is missing here is what nobody has asked for;
// above all: processes, sockets, new namespaces, mounts, tracing, other processes' memory, keys,
// io_uring, bpf, anonymous files, and shared memory.
constexpr const char* kWorkerCalls[] = {
    // Memory and threads' own affairs.
    "brk", "mmap", "munmap", "mprotect", "mremap", "madvise", "futex", "set_robust_list",
    "get_robust_list", "set_tid_address", "rseq", "membarrier", "arch_prctl", "sched_yield",
    "sched_getaffinity", "getcpu",
    // Files that are open, or may be opened.
    "read", "write", "readv", "writev", "pread64", "pwrite64", "lseek", "close", "close_range",
    "dup", "dup2", "dup3", "access", "faccessat", "faccessat2", "stat", "lstat", "fstat",
    "newfstatat", "statx", "readlink", "readlinkat", "getdents64", "getcwd", "poll", "ppoll",
    "select", "pselect6",
    // Time, and what the machine is.
    "clock_gettime", "clock_getres", "clock_nanosleep", "nanosleep", "gettimeofday", "time",
    "times", "getrusage", "getrandom", "uname", "sysinfo",
    // The process's own identity, its signals, and its end.
    "getpid", "gettid", "getppid", "getuid", "geteuid", "getgid", "getegid", "getpgrp", "getrlimit",
    "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "rt_sigpending", "sigaltstack",
    "restart_syscall", "exit", "exit_group"};

constexpr const char* kToolCalls[] = {
    "execve",    "fork",     "vfork",     "wait4",     "waitid",          "pipe",
    "pipe2",     "unlink",   "unlinkat",  "rename",    "renameat",        "renameat2",
    "mkdir",     "mkdirat",  "rmdir",     "chmod",     "fchmod",          "fchmodat",
    "umask",     "truncate", "ftruncate", "fallocate", "copy_file_range", "sendfile",
    "fadvise64", "fsync",    "fdatasync", "utimensat", "chdir",           "fchdir",
    "statfs",    "fstatfs",  "setrlimit", "flock",     "alarm",           "setitimer",
    "getpgid",   "getsid"};

// The commands that C++ gives to a descriptor. Others would have the kernel send signals to any process of the
// user (F_SETOWN, F_SETSIG), or tell of what others do with a file.
constexpr int kDescriptorCommands[] = {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL};

// To open a file for reading; a worker has none to write.
constexpr std::uint64_t kToWrite =
    O_WRONLY | O_RDWR | O_CREAT | O_TRUNC | (O_TMPFILE & ~O_DIRECTORY) | O_ASYNC | O_DIRECT;

constexpr std::uint64_t kNewNamespaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS |
                                         CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;

class Filter {
 public:
  Filter() : context_(seccomp_init(SCMP_ACT_ERRNO(EPERM)), &seccomp_release) {
    if (!context_) throw pt::Error("no filter of system calls can be made");
  }

  // `condition`s are about the call's arguments; all must hold.
  template <class... Condition>
  void allow(const char* name, Condition... condition) {
    add(SCMP_ACT_ALLOW, name, condition...);
  }
  template <class... Condition>
  void add(std::uint32_t action, const char* name, Condition... condition) {
    const int call = seccomp_syscall_resolve_name(name);
    if (call == __NR_SCMP_ERROR) return;  // a machine without it
    check(seccomp_rule_add(context_.get(), action, call, sizeof...(condition), condition...));
  }
  void load() { check(seccomp_load(context_.get())); }

 private:
  static void check(int result) {
    if (result < 0) {
      throw pt::Error(std::string("system calls cannot be filtered: ") + std::strerror(-result));
    }
  }

  std::unique_ptr<void, decltype(&seccomp_release)> context_;
};

}  // namespace

namespace {

// Allows the commands and flags that an honest program needs. The others end the process: nobody tries
// them to find out what a machine can do.
void allow_descriptors(Filter& filter, bool tools) {
  for (const int command : kDescriptorCommands) {
    filter.allow("fcntl", SCMP_A1(SCMP_CMP_EQ, static_cast<scmp_datum_t>(command)));
  }
  filter.allow("fcntl", SCMP_A1(SCMP_CMP_EQ, F_SETFL), SCMP_A2(SCMP_CMP_MASKED_EQ, O_ASYNC, 0));
  for (const int command : {F_SETOWN, F_SETOWN_EX, F_SETSIG, F_SETLEASE, F_NOTIFY}) {
    filter.add(SCMP_ACT_KILL_PROCESS, "fcntl",
               SCMP_A1(SCMP_CMP_EQ, static_cast<scmp_datum_t>(command)));
  }
  filter.add(SCMP_ACT_KILL_PROCESS, "fcntl", SCMP_A1(SCMP_CMP_EQ, F_SETFL),
             SCMP_A2(SCMP_CMP_MASKED_EQ, O_ASYNC, O_ASYNC));
  filter.allow("ioctl", SCMP_A1(SCMP_CMP_MASKED_EQ, 0xffffffff, TCGETS));
  for (const std::uint64_t request : {FIOASYNC, FIOSETOWN, SIOCSPGRP, TIOCSTI, TIOCSCTTY}) {
    filter.add(SCMP_ACT_KILL_PROCESS, "ioctl", SCMP_A1(SCMP_CMP_MASKED_EQ, 0xffffffff, request));
  }
  const std::uint64_t closed = tools ? std::uint64_t{O_ASYNC} : kToWrite;
  filter.allow("open", SCMP_A1(SCMP_CMP_MASKED_EQ, closed, 0));
  filter.allow("openat", SCMP_A2(SCMP_CMP_MASKED_EQ, closed, 0));
}

}  // namespace

void filter_system_calls(int program, bool tools) {
  Filter filter;
  allow_descriptors(filter, tools);
  for (const char* name : kWorkerCalls) filter.allow(name);
  const auto self = static_cast<scmp_datum_t>(getpid());
  for (const char* name : {"kill", "tgkill"}) filter.allow(name, SCMP_A0(SCMP_CMP_EQ, self));
  filter.allow("prlimit64", SCMP_A0(SCMP_CMP_EQ, 0));
  filter.allow("execveat", SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(program)),
               SCMP_A4(SCMP_CMP_EQ, AT_EMPTY_PATH));
  if (tools) {
    for (const char* name : kToolCalls) filter.allow(name);
    filter.allow("clone", SCMP_A0(SCMP_CMP_MASKED_EQ, kNewNamespaces, 0));
    // Its flags are out of a filter's reach; without it, clone is asked.
    filter.add(SCMP_ACT_ERRNO(ENOSYS), "clone3");
  }
  filter.load();
}

#else

void filter_system_calls(int, bool) {}

#endif

}  // namespace grader::sandbox::box
