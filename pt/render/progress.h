#pragma once

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

namespace pt {

// Shows how far the render is, on standard error: on a terminal a bar with the time left, elsewhere
// a line for every tenth and every two seconds, of long renders fewer. It prints nothing for very short renders.
class Progress {
 public:
  Progress();

  // The part done, in [0, 1]. Not safe from several threads at a time.
  void show(double part);

  // Removes the bar, so that what is printed next starts on a clean line.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
  int percent_ = 0;
  bool visible_ = false;
};

// The progress of steps whose length only an estimate tells. It is shown by the clock, from a thread of its own, so that
// a long step is not silent. Until the estimate is there, a sentence says what is done.
class TimedProgress {
 public:
  explicit TimedProgress(std::string first) : first_(std::move(first)) {}
  ~TimedProgress() { clear(); }
  TimedProgress(const TimedProgress&) = delete;
  TimedProgress& operator=(const TimedProgress&) = delete;

  // The rest takes so many seconds. Prints nothing for very short ones.
  void expect(double seconds);

  // Ends it, and removes the bar.
  void clear();

 private:
  static constexpr double kPause = 2;  // seconds
  double passed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  void tick();

  const std::string first_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<double> until_ = 0;  // seconds after the start; 0: not known yet
  Progress progress_;
  std::atomic<bool> ends_ = false;
  std::thread thread_{[this] { tick(); }};
};

}  // namespace pt
