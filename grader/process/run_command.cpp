#include "grader/process/run_command.h"

#include "grader/process/descriptor.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <optional>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>

namespace grader {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

// The status of a child that ends by itself before the deadline.
std::optional<int> await(pid_t pid, Clock::time_point deadline) {
  for (milliseconds pause{0}; Clock::now() < deadline; pause = milliseconds(5)) {
    int status = 0;
    if (waitpid(pid, &status, WNOHANG) == pid) return status;
    poll(nullptr, 0, static_cast<int>(pause.count()));
  }
  return std::nullopt;
}

}  // namespace

CommandResult run_command(Child child, milliseconds limit) {
  CommandResult result;
  const auto start = Clock::now();
  const auto deadline = start + limit;
  Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  Pipe output = make_pipe();
  child.descriptors = {nothing.number(), output.write_end.number(), output.write_end.number()};
  const pid_t pid = spawn(child);
  output.write_end.close();

  char buffer[1 << 16];
  bool open = true;
  while (open) {
    const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) break;
    pollfd waiting{output.read_end.number(), POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(left)) <= 0) continue;
    const ssize_t got = read(output.read_end.number(), buffer, sizeof buffer);
    open = got > 0 || (got < 0 && errno == EINTR);
    if (got > 0) {
      const std::size_t room = kMaxOutput - result.output.size();
      result.output.append(buffer, std::min(room, static_cast<std::size_t>(got)));
    }
  }
  const std::optional<int> status = await(pid, deadline);
  result.timed_out = !status;
  result.status = status ? *status : kill_child(pid);
  kill(-pid, SIGKILL);  // what it left behind
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

}  // namespace grader
