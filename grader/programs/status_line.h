#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace grader::programs {

// Shows on standard error what a long run is doing, even while no step ends: on a terminal one line
// that is rewritten every second, elsewhere a line every ten seconds. A run that ends earlier shows
// nothing. May be used by several threads.
class StatusLine {
 public:
  enum class Output { terminal, log, none };

  // The kind of output that standard error is.
  static Output standard();

  // `pause`: between two lines, if not as said above.
  explicit StatusLine(Output output = standard(), std::chrono::milliseconds pause = {});
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  // The current work, and the part of it that is done, in [0, 1], from which the line tells the time left. The work
  // begins where the part is 0: what came before says nothing about the rest.
  void show(const std::string& what, double part);

  // Removes the line, so that what is printed next starts on a clean one. It comes back.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  void print();

  const Output output_;
  const std::chrono::milliseconds pause_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point start_of_work_ = start_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string what_;
  double part_ = 0;
  bool visible_ = false, ended_ = false;
  std::thread thread_;
};

}  // namespace grader::programs
