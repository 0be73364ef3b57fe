#include "pt/render/progress.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include <unistd.h>

namespace pt {

namespace {

constexpr double kQuiet = 1;      // seconds before the first word
constexpr double kRefresh = 0.1;  // seconds between two bars
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
  } else if (const int tenths = static_cast<int>(part * 10); tenths > tenths_ && tenths < 10) {
    tenths_ = tenths;
    std::fprintf(stderr, "%d %% after %.0f s, about %.0f s left\n", 10 * tenths, elapsed, left);
  }
}

void Progress::clear() {
  if (visible_) std::fprintf(stderr, "\r%*s\r", kBarWidth + 30, "");
  visible_ = false;
}

}  // namespace pt
