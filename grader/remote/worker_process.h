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
// and nothing waits beyond the deadline.
class WorkerProcess {
 public:
  // In a box of the tier.
  WorkerProcess(const std::string& program, Tier tier, std::size_t max_printed);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  // Both throw WorkerFailed.
  void send(Kind kind, std::uint64_t sequence, std::string_view payload,
            Clock::time_point deadline);
  Message receive(std::uint64_t sequence, Clock::time_point deadline);

  // The beginning of what it has printed.
  const std::string& printed() const { return printed_; }

 private:
  // Waits until the descriptor is ready, and meanwhile takes what the worker prints.
  void wait(const Descriptor& descriptor, short event, Clock::time_point deadline);
  void take_output();
  void fill(std::size_t size, Clock::time_point deadline);  // until buffer_ has so many bytes
  [[noreturn]] void ended();

  pid_t pid_ = -1;
  Tier tier_;
  Descriptor to_worker_, from_worker_, output_;
  std::string buffer_;  // received and not yet used
  std::string printed_;
  std::size_t max_printed_;
  std::size_t bytes_printed_ = 0;
};

}  // namespace grader::remote
