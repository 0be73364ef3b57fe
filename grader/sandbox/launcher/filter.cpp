#include "grader/sandbox/launcher/filter.h"

#include "pt/error.h"

#if FIRSTLIGHT_SECCOMP
#include <cerrno>
#include <cstring>
#include <memory>

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
    "dup", "dup2", "dup3", "fcntl", "open", "openat", "access", "faccessat", "faccessat2", "stat",
    "lstat", "fstat", "newfstatat", "statx", "readlink", "readlinkat", "getdents64", "getcwd",
    "poll", "ppoll", "select", "pselect6",
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

void filter_system_calls(int program, bool tools) {
  Filter filter;
  for (const char* name : kWorkerCalls) filter.allow(name);
  const auto self = static_cast<scmp_datum_t>(getpid());
  for (const char* name : {"kill", "tgkill"}) filter.allow(name, SCMP_A0(SCMP_CMP_EQ, self));
  filter.allow("prlimit64", SCMP_A0(SCMP_CMP_EQ, 0));
  filter.allow("ioctl", SCMP_A1(SCMP_CMP_MASKED_EQ, 0xffffffff, TCGETS));
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
