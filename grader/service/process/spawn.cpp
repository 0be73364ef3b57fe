#include "grader/service/process/spawn.h"

#include "grader/base/descriptor.h"
#include "grader/service/process/linux_calls.h"
#include "grader/service/process/memory_group.h"
#include "pt/error.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <mutex>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

// macOS has it in no header.
extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace grader::process {

namespace {

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> all;
  all.reserve(texts.size() + 1);
  for (const std::string& text : texts) all.push_back(const_cast<char*>(text.c_str()));
  all.push_back(nullptr);
  return all;
}

// No code from here to exec may allocate: another thread may hold the allocator's lock.

// Moves the descriptors to free numbers first, out of the way, and then to their final numbers.
void arrange(std::vector<int>& descriptors) {
  const int count = static_cast<int>(descriptors.size());
  for (int& descriptor : descriptors) {
    descriptor = fcntl(descriptor, F_DUPFD, count);
    if (descriptor < 0) _exit(127);
  }
  for (int i = 0; i < count; ++i) {
    if (dup2(descriptors[i], i) < 0) _exit(127);
  }
  close_from(count);
}

constexpr const char* kKernelsChoice = "/proc/self/oom_score_adj";

// The score by which the kernel chooses a process to kill if no memory is left: a child before its
// parent, a worker before the judge. Empty if the kernel does not report it.
std::string score_of_children() {
  std::ifstream file(kKernelsChoice);
  int own = 0;
  return file >> own ? std::to_string(std::min(own + 300, 1000)) : "";
}

void set_score(const std::string& score) {
  const int file = score.empty() ? -1 : open(kKernelsChoice, O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  [[maybe_unused]] const ssize_t written = write(file, score.data(), score.size());
}

// The control group for the child; empty: it stays in ours.
std::string group_of(const Child& child) {
  const auto text_of = [](const char* path) {
    std::ifstream file(path);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  static MemoryGroups groups(
      place_for_groups(text_of("/proc/self/mountinfo"), text_of("/proc/self/cgroup")));
  return child.tree_memory ? groups.make(*child.tree_memory) : "";
}

[[noreturn]] void become(const Child& child, std::vector<int>& descriptors, char* const* command,
                         char* const* environment, pid_t parent, const std::string& score,
                         const std::string& group) {
  setpgid(0, 0);
  stay_with_parent();
  if (getppid() != parent) _exit(127);  // the parent died before the line above
  std::signal(SIGPIPE, SIG_IGN);
  arrange(descriptors);
  if (!child.directory.empty() && chdir(child.directory.c_str()) != 0) _exit(127);
  if (!set_limits(child.limits)) _exit(127);
  set_score(score);
  if (!group.empty() && !join_group(group.c_str(), 0)) _exit(127);
  execve(command[0], command, environment);
  _exit(127);
}

}  // namespace

std::vector<std::string> own_environment() {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) all.emplace_back(*entry);
  return all;
}

pid_t spawn(const Child& child) {
  const std::vector<char*> command = pointers(child.command);
  const std::vector<char*> environment = pointers(child.environment);
  std::vector<int> descriptors = child.descriptors;
  reap_orphans();
  const pid_t parent = getpid();
  static const std::string score = score_of_children();
  // A group without processes looks as if it had ended.
  static std::mutex groups;
  const std::lock_guard lock(groups);
  const std::string group = group_of(child);
  const pid_t pid = fork();
  if (pid < 0) {
    throw pt::Error(fmt::format("cannot start {}: {}", child.command.at(0), std::strerror(errno)));
  }
  if (pid == 0)
    become(child, descriptors, command.data(), environment.data(), parent, score, group);
  setpgid(pid, pid);  // in case we are first; fails once the child has run exec
  if (!group.empty()) join_group(group.c_str(), pid);
  return pid;
}

void end_child(pid_t pid) {
  kill(-pid, SIGKILL);
  kill(pid, SIGKILL);
}

int kill_child(pid_t pid) {
  end_child(pid);
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string describe_status(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  return fmt::format("exit status {}", WEXITSTATUS(status));
}

}  // namespace grader::process
