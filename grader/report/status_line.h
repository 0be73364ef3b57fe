#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace grader::report {

// Shows on standard error what a long run is doing, even while no step ends: on a terminal one line
// that is rewritten every second, elsewhere a line every ten seconds. A run that ends earlier shows
// nothing. May be used by several threads.
class StatusLine {
 public:
  enum class Output { terminal, log, none };

  // The kind of output of standard error.
  static Output standard();

  // `pause` is the time between two lines, if not as above.
  explicit StatusLine(Output output = standard(), std::chrono::milliseconds pause = {});
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  // Sets the current work and the part of it that is done, in [0, 1], from which the line estimates the time left.
  // The work begins when the part is 0: the time before does not count.
  void show(const std::string& what, double part);

  // Removes the line, so that the next output starts on a clean line. It comes back later.
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

}  // namespace grader::report
