#pragma once

#include "grader/report/terminal.h"
#include "grader/results/results.h"
#include "grader/service/build/config.h"

#include <string>
#include <vector>

namespace grader::watch {

// The verdicts on all tasks while they are watched, and the failure that is shown.
class Verdicts {
 public:
  Verdicts(const std::vector<build::TaskConfig>& tasks, std::string folder,
           report::TerminalStyle style);

  // Takes over the verdicts of a run; tasks that it did not judge stay as they are.
  void update(const results::Results& results);

  // The number of tasks that pass, as a bar and in words: one line. It has no points: watch does not judge
  // pictures, so their points would be missing.
  std::string bar() const;

  // Returns whether nothing is left to do.
  bool all_pass() const;

  // Lists the state and the file of each task.
  std::string list() const;

  // The state of the task; empty if it is not judged yet.
  std::string state(const std::string& slug) const;

  // The command that shows a picture of the task in the view, best one that fails; empty if none was rendered.
  std::string how_to_look(const std::string& slug) const;

  // The first failure of the task. If it passes, a sentence that says so, and then the failure that
  // was shown before, or show_first(). If it is blocked, the first failure of the task that blocks it.
  std::string show(const std::string& slug);

  // The first failure of all tasks; if there is none, next().
  std::string show_first();

  // The failure after the one shown last, or the next task that is not written yet; after the last
  // task comes the first.
  std::string next();

  // The task that was shown last, and the promise if its failure was shown.
  const std::string& slug() const { return tasks_[task_].slug; }
  const std::string& promise() const { return promise_; }

 private:
  const results::TaskResult* find(const std::string& slug) const;
  bool is_clone(const std::string& slug) const;
  std::string place_of(const build::TaskConfig& task) const;
  const results::TaskResult* first_blocker(const results::TaskResult& task) const;
  std::vector<report::FailureText> items(std::size_t task) const;
  std::string show_item(const report::FailureText& item);

  const std::vector<build::TaskConfig>& tasks_;
  std::string folder_;
  report::TerminalStyle style_;
  results::Results known_;  // tasks in the order of the course
  std::size_t task_ = 0;    // the task that is shown
  std::size_t item_ = 0;    // the next item of that task to show
  std::string promise_;
};

}  // namespace grader::watch
