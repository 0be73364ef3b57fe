#pragma once

#include "grader/service/process/spawn.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>

namespace grader::process {

struct CommandResult {
  int status = 0;  // as waitpid gives it
  bool timed_out = false;
  std::string output;  // both streams together, the first kMaxOutput bytes
  double seconds = 0;

  bool ok() const { return !timed_out && status == 0; }
};

// The reason why one of our own programs failed: its last line, or how it ended.
std::string fault_of(const CommandResult& result);

inline constexpr std::size_t kMaxOutput = std::size_t{1} << 18;

// For our own programs, whose own limits are far lower.
inline constexpr std::chrono::seconds kProgramTime{1500};

// Runs a command until it ends, or until it and its descendants have used the processor time
// `most`, and keeps its output. Other load does not count, and sleep is limited too
// (grader/service/process/time_limit.h). Sets descriptors 0 to 2: both outputs are read, and the
// input is child.descriptors[0], or empty. Throws pt::Error if the machine is too busy, and Stopped
// soon after `stop` has become true, when it has ended the command. std::stop_token is not in every library.
CommandResult run_command(Child child, std::chrono::milliseconds most,
                          const std::atomic<bool>* stop = nullptr);

struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("it was stopped") {}
};

}  // namespace grader::process
