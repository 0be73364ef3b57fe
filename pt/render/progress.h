#pragma once

#include <chrono>

namespace pt {

// Shows how far the render is, on standard error: on a terminal a bar with the time left, elsewhere
// a line for every tenth. It prints nothing for very short renders.
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
  int tenths_ = 0;
  bool visible_ = false;
};

}  // namespace pt
