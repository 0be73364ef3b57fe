#include "grader/service/sandbox/launcher/filter.h"

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

// Names, as machines have different calls. A call in no list fails with EPERM: libraries try calls
// to find out what a machine can do, and newer libraries try calls unknown today.
constexpr const char* kWorkerCalls[] = {
    // Memory and threads' own affairs.
    "brk", "mmap", "munmap", "mprotect", "mremap", "madvise", "futex", "set_robust_list",
    "get_robust_list", "set_tid_address", "rseq", "membarrier", "arch_prctl", "sched_yield",
    "sched_getaffinity", "getcpu",
    // Files that are open or may be opened.
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

// Calls of attacks. No library tries them to find out what a machine can do, so a process that
// makes one is ended. docs/decisions/0020 has the reasons, also for the calls that fail with EPERM.
constexpr const char* kAttacks[] = {
    // Other processes: their memory, descriptors and signals.
    "ptrace", "process_vm_readv", "process_vm_writev", "process_madvise", "pidfd_open",
    "pidfd_getfd", "pidfd_send_signal", "kcmp", "rt_sigqueueinfo", "rt_tgsigqueueinfo",
    // Another root, files outside the box, and what others do with their files.
    "unshare", "setns", "mount", "umount2", "pivot_root", "chroot", "move_mount", "open_tree",
    "fsopen", "fsconfig", "fsmount", "fspick", "mount_setattr", "open_by_handle_at", "inotify_init",
    "inotify_init1", "fanotify_init",
    // The kernel and the machine.
    "bpf", "perf_event_open", "userfaultfd", "io_uring_setup", "add_key", "request_key", "keyctl",
    "init_module", "finit_module", "delete_module", "kexec_load", "kexec_file_load", "reboot",
    "swapon", "swapoff", "acct", "quotactl", "syslog", "iopl", "ioperm", "modify_ldt",
    "settimeofday", "clock_settime", "sethostname", "setdomainname",
    // Another user.
    "setuid", "setgid", "setreuid", "setregid", "setresuid", "setresgid", "setfsuid", "setfsgid",
    "setgroups", "capset"};

// Calls of attacks for a worker only. A compiler, or a script in its place, may try them.
constexpr const char* kWorkerAttacks[] = {"execve", "setsid", "setpgid", "personality",
                                          // Memory that outlives the process or that others see.
                                          "memfd_create", "memfd_secret", "shmget", "shmat",
                                          "semget", "msgget", "mq_open"};

// Commands for descriptors that C++ needs, and commands that would make the kernel send signals to
// any process of the user, or report what others do with a file.
constexpr int kDescriptorCommands[] = {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL};
constexpr int kSignalCommands[] = {F_SETOWN, F_SETOWN_EX, F_SETSIG, F_SETLEASE, F_NOTIFY};
// The same for devices, and commands that write to somebody's terminal.
constexpr std::uint64_t kDeviceAttacks[] = {FIOASYNC,  FIOSETOWN, SIOCSPGRP, TIOCSTI,
                                            TIOCLINUX, TIOCSETD,  TIOCCONS,  TIOCSCTTY};

// The flags that open a file for writing: a worker has no file to write.
constexpr std::uint64_t kToWrite =
    O_WRONLY | O_RDWR | O_CREAT | O_TRUNC | (O_TMPFILE & ~O_DIRECTORY);
// Flags that no program needs.
constexpr std::uint64_t kOddFlags[] = {O_ASYNC, O_DIRECT};

// The bits that the kernel reads of an int argument.
constexpr std::uint64_t kInt = 0xffffffff;

constexpr std::uint64_t kNewNamespaces[] = {CLONE_NEWNS,  CLONE_NEWCGROUP, CLONE_NEWUTS,
                                            CLONE_NEWIPC, CLONE_NEWUSER,   CLONE_NEWPID,
                                            CLONE_NEWNET};

class Filter {
 public:
  Filter() : context_(seccomp_init(SCMP_ACT_ERRNO(EPERM)), &seccomp_release) {
    if (!context_) throw pt::Error("no filter of system calls can be made");
    // Calls with the numbers of another processor type (int 0x80).
    check(seccomp_attr_set(context_.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS));
  }

  // `condition`s are about the call's arguments; all must hold.
  template <class... Condition>
  void allow(const char* name, Condition... condition) {
    add(SCMP_ACT_ALLOW, name, condition...);
  }
  template <class... Condition>
  void kill(const char* name, Condition... condition) {
    add(SCMP_ACT_KILL_PROCESS, name, condition...);
  }
  template <class... Condition>
  void add(std::uint32_t action, const char* name, Condition... condition) {
    const int call = seccomp_syscall_resolve_name(name);
    if (call == __NR_SCMP_ERROR) return;  // this machine does not have the call
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

scmp_datum_t datum(int number) { return static_cast<scmp_datum_t>(number); }

void filter_descriptors(Filter& filter) {
  for (const int command : kDescriptorCommands) {
    filter.allow("fcntl", SCMP_A1(SCMP_CMP_EQ, datum(command)));
  }
  filter.allow("fcntl", SCMP_A1(SCMP_CMP_EQ, F_SETFL), SCMP_A2(SCMP_CMP_MASKED_EQ, O_ASYNC, 0));
  for (const int command : kSignalCommands) {
    filter.kill("fcntl", SCMP_A1(SCMP_CMP_MASKED_EQ, kInt, datum(command)));
  }
  filter.kill("fcntl", SCMP_A1(SCMP_CMP_MASKED_EQ, kInt, F_SETFL),
              SCMP_A2(SCMP_CMP_MASKED_EQ, O_ASYNC, O_ASYNC));
  filter.allow("ioctl", SCMP_A1(SCMP_CMP_MASKED_EQ, kInt, TCGETS));
  for (const std::uint64_t request : kDeviceAttacks) {
    filter.kill("ioctl", SCMP_A1(SCMP_CMP_MASKED_EQ, kInt, request));
  }
}

void filter_opening(Filter& filter, bool tools) {
  std::uint64_t closed = tools ? 0 : kToWrite;
  for (const std::uint64_t flag : kOddFlags) {
    closed |= flag;
    filter.kill("open", SCMP_A1(SCMP_CMP_MASKED_EQ, flag, flag));
    filter.kill("openat", SCMP_A2(SCMP_CMP_MASKED_EQ, flag, flag));
  }
  filter.allow("open", SCMP_A1(SCMP_CMP_MASKED_EQ, closed, 0));
  filter.allow("openat", SCMP_A2(SCMP_CMP_MASKED_EQ, closed, 0));
}

void filter_processes(Filter& filter, int program, bool tools) {
  const scmp_datum_t self = datum(getpid());
  for (const char* name : {"kill", "tgkill"}) {
    filter.allow(name, SCMP_A0(SCMP_CMP_EQ, self));
    // A compiler's driver ends its parts, which are other processes than this one.
    if (!tools) filter.kill(name, SCMP_A0(SCMP_CMP_NE, self));
  }
  filter.allow("prlimit64", SCMP_A0(SCMP_CMP_EQ, 0));
  filter.kill("prlimit64", SCMP_A0(SCMP_CMP_NE, 0));
  filter.allow("execveat", SCMP_A0(SCMP_CMP_EQ, datum(program)),
               SCMP_A4(SCMP_CMP_EQ, AT_EMPTY_PATH));
  filter.kill("execveat", SCMP_A0(SCMP_CMP_NE, datum(program)));
  for (const std::uint64_t kind : kNewNamespaces) {
    filter.kill("clone", SCMP_A0(SCMP_CMP_MASKED_EQ, kind, kind));
  }
}

}  // namespace

void filter_system_calls(int program, bool tools) {
  Filter filter;
  filter_descriptors(filter);
  filter_opening(filter, tools);
  filter_processes(filter, program, tools);
  for (const char* name : kWorkerCalls) filter.allow(name);
  for (const char* name : kAttacks) filter.kill(name);
  if (tools) {
    for (const char* name : kToolCalls) filter.allow(name);
    std::uint64_t namespaces = 0;
    for (const std::uint64_t kind : kNewNamespaces) namespaces |= kind;
    filter.allow("clone", SCMP_A0(SCMP_CMP_MASKED_EQ, namespaces, 0));
    // A filter cannot read its flags; without it, libraries use clone.
    filter.add(SCMP_ACT_ERRNO(ENOSYS), "clone3");
  } else {
    for (const char* name : kWorkerAttacks) filter.kill(name);
  }
  filter.load();
}

#else

void filter_system_calls(int, bool) {}

#endif

}  // namespace grader::sandbox::box
