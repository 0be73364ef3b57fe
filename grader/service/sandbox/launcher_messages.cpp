#include "grader/service/sandbox/launcher_messages.h"

#include <cstring>

#include <sys/wait.h>
#include <unistd.h>

namespace grader::sandbox {

namespace {

constexpr std::size_t kStatus = sizeof(int);

}  // namespace

void LauncherMessages::listen(const base::Descriptor& launcher) {
  constexpr std::size_t kMaxBytes = 2 + kStatus;
  char bytes[kMaxBytes];
  const ssize_t count = read(launcher.number(), bytes, kMaxBytes);
  if (count > 0) bytes_.append(bytes, static_cast<std::size_t>(count));
}

bool LauncherMessages::has_started() const {
  return bytes_.size() - (bytes_.size() >= kStatus ? kStatus : 0) == 1;
}

std::optional<int> LauncherMessages::status() const {
  if (bytes_.size() < kStatus) return std::nullopt;
  int status = 0;
  std::memcpy(&status, bytes_.data() + bytes_.size() - kStatus, kStatus);
  return status;
}

// Without a message the child's own status decides. Inside bubblewrap, the launcher exits like a
// shell, with 128 plus the number of the signal.
int program_status(int status, Tier tier, const LauncherMessages& messages) {
  if (messages.status()) return *messages.status();
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  return tier == Tier::bubblewrap && code > 128 && code <= 128 + 64 ? code - 128 : status;
}

}  // namespace grader::sandbox
