#pragma once

#include "grader/base/descriptor.h"
#include "grader/service/process/spawn.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace grader::watch {

// A program of ours that runs while we do other things. The destructor ends it if it has not ended before.
class Running {
 public:
  // The program inherits our environment, has no input, and its output is kept.
  explicit Running(const std::vector<std::string>& command);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  // Its status as waitpid gives it, once it has ended. Never waits; SIGCHLD says when to ask again.
  std::optional<int> poll();

  // Readable when it has printed something: poll() takes it, so that it never waits for us.
  int descriptor() const { return output_.number(); }

  const std::string& output() const { return text_; }
  double seconds() const;

 private:
  void read_output();

  base::Descriptor output_;
  pid_t pid_ = -1;  // -1: it has ended
  std::string text_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace grader::watch
