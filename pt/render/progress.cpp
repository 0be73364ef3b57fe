#include "pt/render/progress.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include <unistd.h>

namespace pt {

namespace {

constexpr double kQuiet = 1;         // seconds before the first word
constexpr double kRefresh = 0.1;     // seconds between two bars
constexpr double kPause = 2;         // seconds between two lines, and of long renders
constexpr double kOfElapsed = 0.02;  // this part of the time so far
constexpr int kBarWidth = 40;

}  // namespace

Progress::Progress() : terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::show(double part) {
  const auto now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  if (elapsed < kQuiet || !(part > 0)) return;
  const double left = elapsed * (1 - part) / part;
  if (terminal_) {
    if (std::chrono::duration<double>(now - shown_).count() < kRefresh) return;
    shown_ = now;
    const int filled = static_cast<int>(part * kBarWidth);
    const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
    std::fprintf(stderr, "\r[%s] %3.0f %%, %.0f s left  ", bar.c_str(), 100 * part, left);
    visible_ = true;
    return;
  }
  const int percent = static_cast<int>(part * 100);
  const double silent = std::chrono::duration<double>(now - shown_).count();
  const bool is_tenth = percent / 10 > percent_ / 10;
  if (percent >= 100 || !(is_tenth || silent >= std::max(kPause, kOfElapsed * elapsed))) return;
  percent_ = percent;
  shown_ = now;
  std::fprintf(stderr, "%d %% after %.0f s, about %.0f s left\n", percent, elapsed, left);
}

void Progress::clear() {
  if (visible_) std::fprintf(stderr, "\r%*s\r", kBarWidth + 30, "");
  visible_ = false;
}

void TimedProgress::expect(double seconds) {
  if (seconds >= kPause) std::fprintf(stderr, "measuring takes about %.0f s\n", seconds);
  until_ = passed() + std::max(seconds, kPause);
}

void TimedProgress::clear() {
  if (!thread_.joinable()) return;
  ends_ = true;
  thread_.join();
  progress_.clear();
}

void TimedProgress::tick() {
  double said = 0;
  while (!ends_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const double now = passed(), until = until_;
    if (until > 0) {
      progress_.show(now / std::max(until, now + 1));
    } else if (now >= said + kPause) {
      std::fprintf(stderr, "%s (%.0f s)\n", first_.c_str(), now);
      said = now;
    }
  }
}

}  // namespace pt
