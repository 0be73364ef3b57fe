#pragma once

#include "grader/service/wire/worker_process.h"
#include "measure/calls/message.h"

#include <memory>
#include <string>

namespace measure::calls {

// A worker without an answer: it crashed, never ended, or its task is not written. One sentence.
struct NoAnswer {
  std::string why;
};

// A worker in its box, started by the first request. Only the form of its answers is checked: the
// author of the measured code can make it send anything, but only a chart depends on it.
class Conversation {
 public:
  Conversation(std::string program, grader::sandbox::Tier tier)
      : program_(std::move(program)), tier_(tier) {}

  // Both throw NoAnswer, and pt::Error if no worker can be started.
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

}  // namespace measure::calls
