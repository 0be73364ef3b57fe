#pragma once

#include "grader/wire/worker_process.h"
#include "writeup/measure/message.h"

#include <memory>
#include <string>

namespace writeup::measure {

// A worker did not answer: it crashed, never ended, or its task is not written. A sentence.
struct NoAnswer {
  std::string why;
};

// A worker in its box, started when it is asked for the first time. Only the form of its answers is checked:
// the author of the measured code can make it say anything, and nothing but a chart depends on it.
class Conversation {
 public:
  Conversation(std::string program, grader::sandbox::Tier tier)
      : program_(std::move(program)), tier_(tier) {}

  // Both throw NoAnswer; and pt::Error where no worker can be started.
  Timed time(Request request);
  Found find(Request request);

 private:
  template <class Content>
  Content ask(const Request& request);
  template <class Content>
  Content converse(const Request& request);

  std::string program_;
  grader::sandbox::Tier tier_;
  std::unique_ptr<grader::wire::WorkerProcess> worker_;
  std::uint64_t sequence_ = 0;
};

}  // namespace writeup::measure
