#include "grader/service/process/run_command.h"

#include "grader/base/descriptor.h"
#include "grader/base/printable.h"
#include "grader/service/process/time_limit.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>

namespace grader::process {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

// Returns how long a poll may wait before the limit is checked again.
int milliseconds_until_look(const TimeLimit& limit) {
  const auto left = std::chrono::ceil<milliseconds>(limit.next_look() - Clock::now()).count();
  return static_cast<int>(std::clamp<long long>(left, 0, 1000));
}

// Waits for a while, or until something can be read. Returns whether the limit is over.
bool is_over_after_waiting(TimeLimit& limit, pollfd* awaited, int longest) {
  const int left = std::min(longest, milliseconds_until_look(limit));
  const Wait wait;
  poll(awaited, awaited == nullptr ? 0 : 1, left);
  limit.add_waited(wait.net(milliseconds(left)));
  return Clock::now() >= limit.next_look() && limit.is_over();
}

// Ends its child if an exception is thrown.
class Awaited {
 public:
  explicit Awaited(pid_t pid) : pid_(pid) {}
  ~Awaited() {
    if (pid_ > 0) kill_child(pid_);
  }
  Awaited(const Awaited&) = delete;
  Awaited& operator=(const Awaited&) = delete;
  void has_ended() { pid_ = -1; }

 private:
  pid_t pid_;
};

// The status of a child that ends by itself within the limit.
std::optional<int> await(pid_t pid, TimeLimit& limit) {
  for (int pause = 0;; pause = 5) {
    int status = 0;
    if (waitpid(pid, &status, WNOHANG) == pid) return status;
    if (is_over_after_waiting(limit, nullptr, pause)) return std::nullopt;
  }
}

}  // namespace

std::string fault_of(const CommandResult& result) {
  const std::string& text = result.output;
  const std::size_t end = text.find_last_not_of('\n');
  if (result.timed_out) return "it took too long";
  if (end == std::string::npos) return "it ended with " + describe_status(result.status);
  const std::size_t start = text.rfind('\n', end);
  const std::size_t first = start == std::string::npos ? 0 : start + 1;
  return base::printable(text.substr(first, end + 1 - first), 400);
}

CommandResult run_command(Child child, milliseconds most, const std::atomic<bool>* stop) {
  CommandResult result;
  const auto start = Clock::now();
  base::Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  base::Pipe output = base::make_pipe();
  const int input = child.descriptors.empty() ? nothing.number() : child.descriptors[0];
  child.descriptors.resize(std::max<std::size_t>(child.descriptors.size(), 3));
  child.descriptors[0] = input;
  child.descriptors[1] = child.descriptors[2] = output.write_end.number();
  const pid_t pid = spawn(child);
  Awaited awaited(pid);
  output.write_end.close();
  TimeLimit limit(pid, most);

  char buffer[1 << 16];
  bool open = true, over = false;
  while (open && !over) {
    pollfd waiting{output.read_end.number(), POLLIN, 0};
    over = is_over_after_waiting(limit, &waiting, stop == nullptr ? 1000 : 20);
    if (stop != nullptr && *stop) throw Stopped();
    if (waiting.revents == 0) continue;
    const ssize_t got = read(output.read_end.number(), buffer, sizeof buffer);
    open = got > 0 || (got < 0 && errno == EINTR);
    if (got > 0) {
      const std::size_t room = kMaxOutput - result.output.size();
      result.output.append(buffer, std::min(room, static_cast<std::size_t>(got)));
    }
  }
  const std::optional<int> status = over ? std::nullopt : await(pid, limit);
  result.timed_out = !status;
  result.status = status ? *status : kill_child(pid);
  awaited.has_ended();
  kill(-pid, SIGKILL);  // its remaining processes
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

}  // namespace grader::process
