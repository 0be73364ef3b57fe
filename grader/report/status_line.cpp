#include "grader/report/status_line.h"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

namespace grader::report {

namespace {

constexpr std::chrono::seconds kOnTerminal{1};
constexpr std::chrono::seconds kInLog{10};
constexpr double kBeforeEstimate = 3;  // seconds
constexpr const char* kClearLine = "\r\x1b[K";

}  // namespace

StatusLine::Output StatusLine::standard() {
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal == nullptr || std::string(terminal) == "dumb";
  return isatty(STDERR_FILENO) == 1 && !dumb ? Output::terminal : Output::log;
}

StatusLine::StatusLine(Output output, std::chrono::milliseconds pause)
    : output_(output),
      pause_(pause.count() > 0            ? pause
             : output == Output::terminal ? kOnTerminal
                                          : kInLog) {
  if (output_ != Output::none) thread_ = std::thread([this] { run(); });
}

StatusLine::~StatusLine() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
  clear();
}

void StatusLine::show(const std::string& what, double part) {
  const std::lock_guard lock(mutex_);
  what_ = what;
  part_ = part;
  if (part == 0) start_of_work_ = Clock::now();
  if (visible_) print();
}

void StatusLine::clear() {
  const std::lock_guard lock(mutex_);
  if (visible_) std::fputs(kClearLine, stderr);
  visible_ = false;
}

void StatusLine::run() {
  std::unique_lock lock(mutex_);
  for (auto next = start_ + pause_; !ended_; next += pause_) {
    if (changed_.wait_until(lock, next, [&] { return ended_; })) return;
    if (!what_.empty()) print();
  }
}

// Called with the lock.
void StatusLine::print() {
  const auto seconds_since = [now = Clock::now()](Clock::time_point time) {
    return std::chrono::duration<double>(now - time).count();
  };
  const double worked = seconds_since(start_of_work_);
  std::string line = what_;
  if (part_ > 0 && part_ < 1 && worked >= kBeforeEstimate) {
    line += fmt::format(", about {:.0f} s left", worked * (1 - part_) / part_ + 1);
  }
  line += fmt::format(" ({:.0f} s)", seconds_since(start_));
  visible_ = output_ == Output::terminal;
  std::fputs((visible_ ? kClearLine + line : line + "\n").c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace grader::report
