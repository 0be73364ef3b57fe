#include "grader/service/wire/worker_process.h"

#include "grader/base/printable.h"
#include "grader/service/process/cause_of_end.h"

#include <cerrno>
#include <optional>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>

namespace grader::wire {

namespace {

// Output beyond this size is not read.
constexpr std::size_t kMaxTaken = std::size_t{1} << 20;

// The end of a program's output, which says why it ended.
constexpr std::size_t kMaxLastWords = 2000;

int milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<long long>(left, 0, 1 << 30));
}

int milliseconds(std::chrono::nanoseconds time) {
  return static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(time).count());
}

std::chrono::nanoseconds duration(const timeval& time) {
  return std::chrono::seconds(time.tv_sec) + std::chrono::microseconds(time.tv_usec);
}

}  // namespace

WorkerProcess::WorkerProcess(const std::string& program, sandbox::Tier tier,
                             std::size_t max_printed)
    : tier_(tier), max_printed_(max_printed) {
  base::Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  base::Pipe calls = base::make_pipe(), replies = base::make_pipe(), output = base::make_pipe(),
             launcher = base::make_pipe();
  sandbox::Box box = sandbox::box_of_functions(program, 120);
  box.descriptors = {nothing.number(),           output.write_end.number(),
                     output.write_end.number(),  calls.read_end.number(),
                     replies.write_end.number(), launcher.write_end.number()};
  box.tells_start = true;
  const process::Child child = sandbox::boxed(box, tier);
  held_ = child.held;
  pid_ = process::spawn(child);
  to_worker_ = std::move(calls.write_end);
  from_worker_ = std::move(replies.read_end);
  output_ = std::move(output.read_end);
  launcher_ = std::move(launcher.read_end);
  for (const base::Descriptor* end : {&to_worker_, &from_worker_, &output_, &launcher_})
    base::set_nonblocking(*end);
}

WorkerProcess::~WorkerProcess() {
  if (pid_ > 0) process::kill_child(pid_);
}

// In tier A the program is a descendant of the started child. It surely exists once it has sent
// something.
void WorkerProcess::allow(std::chrono::milliseconds limit) {
  if (worker_ < 0 && tier_ != sandbox::Tier::bubblewrap) worker_ = pid_;
  if (worker_ < 0 && has_answered_) worker_ = process::last_descendant(pid_);
  running_ = process::running_time(worker_);
  limit_ = process::TimeLimit(pid_, limit, running_);
}

void WorkerProcess::send(Kind kind, std::uint64_t sequence, std::string_view payload) {
  const Header header{kMagic, kind, sequence, payload.size()};
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  bytes.append(payload);
  together_.hold(worker_);
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = write(to_worker_.number(), bytes.data() + sent, bytes.size() - sent);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN) {
      wait(to_worker_, POLLOUT);
    } else if (errno != EINTR) {
      ended();
    }
  }
}

Message WorkerProcess::receive(std::uint64_t sequence) {
  fill(sizeof(Header));
  Header header;
  std::memcpy(&header, buffer_.data(), sizeof header);
  const bool known = header.kind == Kind::reply || header.kind == Kind::ask ||
                     header.kind == Kind::threw || header.kind == Kind::asked ||
                     header.kind == Kind::going_on;
  if (header.magic != kMagic || !known || header.sequence != sequence) {
    throw WorkerFailed{results::Cause::bad_reply, "bytes that are not a reply"};
  }
  answered_ += std::min<std::uint64_t>(header.length, kMaxPayload);
  if (header.length > kMaxPayload) {
    throw WorkerFailed{results::Cause::bad_reply,
                       fmt::format("an answer of {} MiB, where {} are the most",
                                   header.length >> 20, kMaxPayload >> 20)};
  }
  fill(sizeof header + header.length);
  Message message{header.kind, buffer_.substr(sizeof header, header.length)};
  buffer_.erase(0, sizeof header + header.length);
  has_answered_ = true;
  return message;
}

void WorkerProcess::fill(std::size_t size) {
  char chunk[1 << 16];
  while (buffer_.size() < size) {
    wait(from_worker_, POLLIN);
    const ssize_t count = read(from_worker_.number(), chunk, sizeof chunk);
    if (count > 0) {
      buffer_.append(chunk, static_cast<std::size_t>(count));
    } else if (count == 0) {
      ended();
    }
  }
}

void WorkerProcess::wait(const base::Descriptor& descriptor, short event) {
  for (bool is_short = true;; is_short = false) {
    pollfd waiting[] = {{descriptor.number(), event, 0}, {output_.number(), POLLIN, 0}};
    const int left = milliseconds_until(limit_.next_look());
    constexpr int kShort = 2;
    const int longest = std::min(left, is_short ? kShort : milliseconds(sleep_.until_look()));
    if (!is_short) together_.let_go();
    // Most answers come at once, so only a long wait, or one of many in a long call, is measured.
    std::optional<process::Wait> wait;
    if (!is_short || limit_.was_looked_at()) wait.emplace();
    const int ready = poll(waiting, 2, longest);  // poll ignores a closed output_, -1
    if (wait) {
      const std::chrono::nanoseconds waited = wait->net(std::chrono::milliseconds(longest));
      limit_.add_waited(waited);
      sleep_.add_waited(waited);
      waited_ += waited;
      watch_sleep();
    }
    if (ready > 0 && waiting[1].revents != 0) take_output();
    if (ready > 0 && waiting[0].revents != 0) return;
    if (left == 0 && limit_.is_over()) {
      running_ = process::running_time(worker_);
      throw WorkerFailed{results::Cause::timeout, ""};
    }
  }
}

// The launcher's time does not count. In tier A the program is the deepest descendant, once the
// launcher has reported that only the program is left to start.
void WorkerProcess::watch_sleep() {
  if (sleep_.until_look() > std::chrono::nanoseconds(0)) return;
  if (!has_started()) messages_.listen(launcher_);
  if (worker_ < 0 && has_started()) worker_ = process::last_descendant(pid_);
  sleep_.look(has_started() ? worker_ : -1);
}

// Output beyond the limit goes to a pipe that nobody reads, so the worker's writes fail.
void WorkerProcess::take_output() {
  char chunk[1 << 16];
  const ssize_t count = read(output_.number(), chunk, sizeof chunk);
  if (count <= 0) {
    if (count == 0) output_.close();
    return;
  }
  bytes_printed_ += static_cast<std::size_t>(count);
  const std::size_t room = max_printed_ - std::min(max_printed_, printed_.size());
  printed_.append(chunk, std::min(room, static_cast<std::size_t>(count)));
  last_words_.append(chunk, static_cast<std::size_t>(count));
  last_words_.erase(0, last_words_.size() - std::min(last_words_.size(), kMaxLastWords));
  if (bytes_printed_ > kMaxTaken) output_.close();
}

bool WorkerProcess::has_started() const {
  return tier_ == sandbox::Tier::limits || messages_.has_started();
}

// The worker closed its side. A dying process looks like that a moment before its status is known.
void WorkerProcess::ended() {
  int status = 0;
  bool dead = false;
  rusage used{};
  for (int i = 0; i < 1000 && !dead; ++i) {
    dead = wait4(pid_, &status, WNOHANG, &used) == pid_;
    if (!dead) poll(nullptr, 0, 2);
  }
  while (output_.is_open() && bytes_printed_ <= kMaxTaken) {
    const std::size_t before = bytes_printed_;
    take_output();
    if (bytes_printed_ == before) break;
  }
  if (!dead) {
    throw WorkerFailed{.text = "it closed its connection to the judge", .hung = true};
  }
  running_ = duration(used.ru_utime) + duration(used.ru_stime);
  kill(-pid_, SIGKILL);
  pid_ = -1;
  messages_.listen(launcher_);
  if (!has_answered_ && !has_started()) {
    throw WorkerNotStarted{last_words_.empty() ? process::describe_status(status)
                                               : base::printable(last_words_, 300)};
  }
  throw WorkerFailed{results::Cause::crash,
                     process::cause_of_end(sandbox::program_status(status, tier_, messages_),
                                           base::printable(last_words_, 2000, true))};
}

std::unique_ptr<WorkerProcess> start_worker(const std::string& program, sandbox::Tier tier,
                                            std::size_t max_printed) {
  try {
    return std::make_unique<WorkerProcess>(program, tier, max_printed);
  } catch (const pt::Error& error) {
    throw WorkerNotStarted{error.what()};
  }
}

}  // namespace grader::wire
