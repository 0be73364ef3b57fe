#pragma once

#include "grader/process/descriptor.h"
#include "grader/property/property.h"
#include "grader/remote/message.h"
#include "grader/sandbox/box.h"

#include <chrono>
#include <string>

namespace grader::remote {

using Clock = std::chrono::steady_clock;

// A conversation that came to nothing. The text says what the worker did, for a person to read.
struct WorkerFailed {
  Cause cause = Cause::crash;
  std::string text;
  bool alive = false;  // the worker may be asked again
};

struct Message {
  Kind kind = Kind::reply;
  std::string payload;
};

// One life of a worker, seen from the judge: it starts with the constructor and ends, whatever the
// worker does, with the destructor. Nothing it sends is believed but what the checks let through,
// and nothing waits beyond the deadline. A deadline is put off by what the worker had to wait for a
// processor, so that a verdict does not depend on what else the machine does.
class WorkerProcess {
 public:
  // In a box of the tier.
  WorkerProcess(const std::string& program, Tier tier, std::size_t max_printed);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  // The deadline is so far from now.
  void allow(std::chrono::milliseconds limit) { deadline_ = Clock::now() + limit; }

  // Both throw WorkerFailed.
  void send(Kind kind, std::uint64_t sequence, std::string_view payload);
  Message receive(std::uint64_t sequence);

  // How long it has waited for a processor until now.
  std::chrono::nanoseconds starved();
  // By how much of that deadlines were put off.
  std::chrono::nanoseconds forgiven() const { return forgiven_; }

  // The beginning of what it has printed.
  const std::string& printed() const { return printed_; }

 private:
  // Waits until the descriptor is ready, and meanwhile takes what the worker prints.
  void wait(const Descriptor& descriptor, short event);
  void put_off_deadline();
  void take_output();
  void fill(std::size_t size);  // until buffer_ has so many bytes
  [[noreturn]] void ended();

  pid_t pid_ = -1;
  Tier tier_;
  Clock::time_point deadline_;
  std::chrono::nanoseconds starved_{0};  // what was known last: a dead process tells nothing
  std::chrono::nanoseconds forgiven_{0};
  Descriptor to_worker_, from_worker_, output_;
  std::string buffer_;  // received and not yet used
  std::string printed_;
  std::size_t max_printed_;
  std::size_t bytes_printed_ = 0;
};

}  // namespace grader::remote
