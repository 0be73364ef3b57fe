#include "grader/results/order.h"

#include "grader/results/summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace grader::results {

namespace {

int rank_of_cause(Cause cause) {
  if (cause == Cause::crash) return 0;
  if (cause == Cause::timeout) return 1;
  if (cause == Cause::not_called) return 4;
  return cause == Cause::wrong ? 3 : 2;
}

using Rank = std::array<int, 8>;

// Of the broken promises of a task.
struct Broken {
  // Nearly all are broken. Then they have one cause, and the contract begins with the simplest.
  bool throughout = false;
  double most_alike = 0;  // the largest likeness
};

Broken broken_of(const TaskResult& task) {
  int all = 0, count = 0;
  Broken broken;
  for (const PromiseResult& each : task.promises) {
    if (each.bonus) continue;
    ++all;
    if (each.held) continue;
    ++count;
    broken.most_alike = std::max(broken.most_alike, each.likeness);
  }
  broken.throughout = 4 * count > 3 * all;
  return broken;
}

Rank rank_of(const PromiseResult& promise, const Broken& broken) {
  constexpr int kFirstInputs = 3, kShortLines = 3, kLongLines = 12;
  // A promise of which half of the checks or fewer fail may be broken only because another one is.
  // Failures together with the submission's other tasks are those of the same checks once more.
  const auto alone = std::ranges::count(promise.failures, false, &Failure::integrated);
  const auto failing = std::max(alone, std::ssize(promise.failures) - alone);
  const int few = promise.checks > 0 && 2 * failing <= promise.checks ? 1 : 0;
  const double less = broken.most_alike - promise.likeness;
  const int unlike = broken.throughout ? static_cast<int>(std::floor(10 * less))
                                       : static_cast<int>(std::lround(100 * less));
  Rank best{promise.bonus ? 1 : 0, 5, unlike, 1, 1, 1, 1, 2};
  for (const Failure& failure : promise.failures) {
    int cause = rank_of_cause(failure.cause);
    if (cause == rank_of_cause(Cause::bad_reply) && less > 0.1) cause = rank_of_cause(Cause::wrong);
    Rank rank{promise.bonus ? 1 : 0, cause, unlike};
    if (!broken.throughout) {
      const int lines = static_cast<int>(failure.input.size());
      rank[3] = failure.statistical ? 1 : 0;
      rank[4] = few;
      rank[5] = failure.simple ? 0 : 1;
      rank[6] = failure.cases_before > kFirstInputs ? 1 : 0;
      rank[7] = lines > kLongLines ? 2 : lines > kShortLines ? 1 : 0;
    }
    best = std::min(best, rank);
  }
  return best;
}

}  // namespace

void put_most_telling_first(std::vector<Failure>& failures) {
  constexpr std::size_t kAlike = 32;  // between inputs of about one length, the first check decides
  const auto rank = [](const Failure& failure) {
    std::size_t length = 0;
    for (const std::string& line : failure.input) length += line.size();
    return std::tuple(failure.integrated, rank_of_cause(failure.cause), !failure.simple,
                      failure.statistical, length / kAlike);
  };
  std::ranges::stable_sort(failures, {}, rank);
}

int importance(const TaskResult& task) {
  if (!is_fault(task.state)) return 9;
  if (!task.mistake.empty()) return 0;
  const auto promises = by_importance(task);
  const bool breaks = !promises.empty() && !promises[0]->bonus;
  if (breaks && !promises[0]->failures.empty()) {
    const int cause = rank_of(*promises[0], broken_of(task))[1];
    return cause == 0 ? 1 : cause < 3 ? 3 : 4;
  }
  if (!task.compiler_output.empty() || task.state == State::rejected) return 2;
  return breaks ? 4 : 5;
}

std::vector<const PromiseResult*> by_importance(const TaskResult& task) {
  std::vector<const PromiseResult*> promises;
  for (const PromiseResult& promise : task.promises) {
    if (!promise.held) promises.push_back(&promise);
  }
  std::stable_sort(promises.begin(), promises.end(),
                   [broken = broken_of(task)](const PromiseResult* a, const PromiseResult* b) {
                     return rank_of(*a, broken) < rank_of(*b, broken);
                   });
  return promises;
}

std::vector<const TaskResult*> by_importance(const Results& results) {
  std::vector<const TaskResult*> tasks;
  for (const TaskResult& task : results.tasks) tasks.push_back(&task);
  std::stable_sort(tasks.begin(), tasks.end(), [](const TaskResult* a, const TaskResult* b) {
    return importance(*a) < importance(*b);
  });
  return tasks;
}

const TaskResult* next_task(const Results& results) {
  const auto tasks = by_importance(results);
  if (!tasks.empty() && is_fault(tasks[0]->state)) return tasks[0];
  const auto unwritten = std::ranges::find(results.tasks, State::not_attempted, &TaskResult::state);
  return unwritten == results.tasks.end() ? nullptr : &*unwritten;
}

}  // namespace grader::results
