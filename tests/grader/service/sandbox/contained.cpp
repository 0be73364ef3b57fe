// contained [--no-programs] PROGRAM [ARGUMENT ...]: runs the program as in a container that cannot
// make namespaces. Docker's own system-call filter forbids them, even to root, and no program can
// undo that. With --no-programs the launcher of boxes cannot start a program either (execveat), so
// that no isolating tier works. Exit status: the program's, or 127 if it cannot run.
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <sched.h>
#include <seccomp.h>
#include <unistd.h>

namespace {

constexpr scmp_datum_t kNamespaces[] = {CLONE_NEWNS,   CLONE_NEWCGROUP, CLONE_NEWUTS, CLONE_NEWIPC,
                                        CLONE_NEWUSER, CLONE_NEWPID,    CLONE_NEWNET};

bool forbid(bool programs) {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  if (filter == nullptr) return false;
  bool all = true;
  const auto refuse = [&](int call, int error) {
    all = seccomp_rule_add(filter, SCMP_ACT_ERRNO(error), call, 0) == 0 && all;
  };
  refuse(SCMP_SYS(unshare), EPERM);
  refuse(SCMP_SYS(setns), EPERM);
  refuse(SCMP_SYS(mount), EPERM);
  // A filter cannot see the flags of clone3. Without clone3, programs use clone.
  refuse(SCMP_SYS(clone3), ENOSYS);
  for (const scmp_datum_t flag : kNamespaces) {
    all = seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1,
                           SCMP_A0(SCMP_CMP_MASKED_EQ, flag, flag)) == 0 &&
          all;
  }
  if (programs) refuse(SCMP_SYS(execveat), EPERM);
  all = all && seccomp_load(filter) == 0;  // no_new_privs: a setuid bwrap gains nothing
  seccomp_release(filter);
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  const bool programs = argc > 1 && std::strcmp(argv[1], "--no-programs") == 0;
  char** command = argv + (programs ? 2 : 1);
  if (argc > 1 && *command != nullptr && forbid(programs)) execv(*command, command);
  std::perror("contained");
  return 127;
}
