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

bool passes(const Results& results) {
  return !results.tasks.empty() &&
         std::all_of(results.tasks.begin(), results.tasks.end(),
                     [](const TaskResult& task) { return task.state == State::pass; });
}

}  // namespace grader::results
