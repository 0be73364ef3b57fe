#include "grader/service/sandbox/launcher/user.h"

#include "pt/error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>

namespace grader::sandbox::box {

namespace {

base::Descriptor open_process(pid_t pid) {
  base::Descriptor process(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));
  if (!process.is_open()) throw pt::Error(std::string("no pidfd: ") + std::strerror(errno));
  return process;
}

// Zombies count as processes until they are reaped, so the number of attempts is bounded.
void kill_all_of(uid_t id) {
  const pid_t killer = fork();
  if (killer == 0) {
    if (setresuid(id, id, id) != 0) _exit(1);
    for (int i = 0; i < 100 && kill(-1, SIGKILL) == 0; ++i) ::poll(nullptr, 0, 1);
    _exit(0);
  }
  waitpid(killer, nullptr, 0);
}

void close_all_but(std::array<int, 3> kept) {
  std::sort(kept.begin(), kept.end());
  unsigned next = 0;
  for (const int number : kept) {
    if (number < 0) continue;
    if (static_cast<unsigned>(number) > next) {
      close_range(next, static_cast<unsigned>(number) - 1, 0);
    }
    next = static_cast<unsigned>(number) + 1;
  }
  close_range(next, ~0U, 0);
}

}  // namespace

User take_any_user() {
  const auto start = static_cast<uid_t>(getpid());
  for (uid_t i = 0; i < kUsersOfTierB.count; ++i) {
    const uid_t id = kUsersOfTierB.first + (start + i) % kUsersOfTierB.count;
    if (getpwuid(id) != nullptr) continue;
    if (std::optional<User> user = take_user(id)) return std::move(*user);
  }
  throw pt::Error("all users for boxes are taken");
}

void become(const User& user) {
  const pid_t parent = getppid();
  if (setgroups(0, nullptr) != 0 || setresgid(user.id, user.id, user.id) != 0 ||
      setresuid(user.id, user.id, user.id) != 0) {
    throw pt::Error(std::string("cannot become another user: ") + std::strerror(errno));
  }
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // needed again: a change of user clears it
  if (getppid() != parent) _exit(127);
}

void start_keeper(const std::optional<User>& user) {
  const pid_t self = getpid();
  const base::Descriptor program = open_process(self), judge = open_process(getppid());
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw pt::Error("no pipe");
  const base::Descriptor ready(ends[0]);
  base::Descriptor signal(ends[1]);
  const pid_t keeper = fork();
  if (keeper < 0) throw pt::Error(std::string("no process: ") + std::strerror(errno));
  if (keeper > 0) {
    // The keeper must leave the group first: if the program ends at once, its group is killed.
    signal.close();
    char byte = 0;
    if (read(ready.number(), &byte, 1) != 1) throw pt::Error("no keeper");
    return;
  }
  setsid();
  prctl(PR_SET_PDEATHSIG, 0);
  if (write(signal.number(), "x", 1) != 1) _exit(1);
  close_all_but({program.number(), judge.number(), user ? user->lock.number() : -1});
  pollfd awaited[] = {{program.number(), POLLIN, 0}, {judge.number(), POLLIN, 0}};
  while (::poll(awaited, 2, -1) < 0 && errno == EINTR) {
  }
  syscall(SYS_pidfd_send_signal, program.number(), SIGKILL, nullptr, 0);
  kill(-self, SIGKILL);
  if (user) kill_all_of(user->id);
  _exit(0);
}

void continue_as_child(int told) {
  const pid_t child = fork();
  if (child < 0) throw pt::Error(std::string("no process: ") + std::strerror(errno));
  if (child == 0) return;
  prctl(PR_SET_DUMPABLE, 0);
  close_all_but({told, -1, -1});
  while (true) {
    int status = 0;
    const pid_t ended = wait(&status);
    if (ended == child) {
      if (told >= 0 && write(told, &status, sizeof status) != sizeof status) _exit(127);
      _exit(WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
    }
    if (ended < 0 && errno != EINTR) _exit(127);
  }
}

}  // namespace grader::sandbox::box
