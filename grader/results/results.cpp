#include "grader/results/results.h"

#include <algorithm>

namespace grader::results {

const char* name(State state) {
  switch (state) {
    case State::pass:
      return "pass";
    case State::fail:
      return "fail";
    case State::crash:
      return "crash";
    case State::timeout:
      return "timeout";
    case State::not_attempted:
      return "not_attempted";
    case State::blocked:
      return "blocked";
    case State::too_noisy:
      return "too_noisy";
    case State::rejected:
      return "rejected";
    case State::not_judged:
      return "not_judged";
  }
  return "";
}

const char* name(Cause cause) {
  switch (cause) {
    case Cause::wrong:
      return "wrong";
    case Cause::crash:
      return "crash";
    case Cause::timeout:
      return "timeout";
    case Cause::bad_reply:
      return "bad reply";
    case Cause::not_attempted:
      return "not attempted";
    case Cause::not_called:
      return "not called";
  }
  return "";
}

State state_of(const TaskResult& task) {
  State state = task.keeps_state ? State::fail : State::pass;
  for (const PromiseResult& promise : task.promises) {
    if (promise.bonus || promise.held) continue;
    if (state == State::pass) state = State::fail;
    for (const Failure& failure : promise.failures) {
      if (failure.cause == Cause::crash) state = State::crash;
      if (failure.cause == Cause::timeout && state != State::crash) state = State::timeout;
    }
  }
  return state;
}

bool passes(const Results& results) {
  return !results.tasks.empty() &&
         std::all_of(results.tasks.begin(), results.tasks.end(),
                     [](const TaskResult& task) { return task.state == State::pass; });
}

}  // namespace grader::results
