#include "grader/sandbox/told.h"

#include <cstring>

#include <sys/wait.h>
#include <unistd.h>

namespace grader::sandbox {

namespace {

constexpr std::size_t kStatus = sizeof(int);

}  // namespace

void Told::listen(const base::Descriptor& launcher) {
  constexpr std::size_t kMost = 2 + kStatus;
  char bytes[kMost];
  const ssize_t count = read(launcher.number(), bytes, kMost);
  if (count > 0) bytes_.append(bytes, static_cast<std::size_t>(count));
}

bool Told::has_started() const {
  return bytes_.size() - (bytes_.size() >= kStatus ? kStatus : 0) == 1;
}

std::optional<int> Told::status() const {
  if (bytes_.size() < kStatus) return std::nullopt;
  int status = 0;
  std::memcpy(&status, bytes_.data() + bytes_.size() - kStatus, kStatus);
  return status;
}

// Without its word: the launcher inside bubblewrap ends as a shell does.
int program_status(int status, Tier tier, const Told& told) {
  if (told.status()) return *told.status();
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  return tier == Tier::bubblewrap && code > 128 && code <= 128 + 64 ? code - 128 : status;
}

}  // namespace grader::sandbox
