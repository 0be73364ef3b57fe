#pragma once

#include "grader/judge/findings.h"
#include "grader/judge/grade.h"

#include <functional>

namespace grader::judge {

// A task on its way to a verdict.
struct Judged {
  const TaskConfig* config = nullptr;
  Built object;              // of the submission's file, if it compiles
  std::string content;       // a hash of that file; the same on every machine
  bool right_alone = false;  // every promise holds with the reference elsewhere
  bool settled = false;      // every promise is decided: alone, and together where asked
  results::TaskResult result;
};

// A task of which nothing has been judged: its promises, as the contract has them.
Judged not_judged(const Config& config, const TaskConfig& task);

// Reads and compiles the file of each task. Leaves an object, or a state that says why there is
// none.
void compile_all(const Builder& builder, const GradeRequest& request, std::vector<Judged>& judged);

// Judges each task by itself: the submission's task, the judge's answers or the reference in all
// other places. Leaves a state for each; what passes here is right by itself. `progress` is called
// after every task, by one thread at a time.
void judge_alone(const Config& config, const Builder& builder, const GradeRequest& request,
                 std::vector<Judged>& judged, const std::function<void()>& progress);

// Puts findings into a result: the state, and every failure with the command that replays it.
void enter(const results::TaskResult& found, const GradeRequest& request,
           results::TaskResult& result);

// The parts of the worker of one task: the task, and in all other places the judge's answers (for
// its properties) or the reference (for its pictures).
enum class Elsewhere { answers, reference };
Built link_alone(const Config& config, const Builder& builder, const Judged& judged,
                 Elsewhere elsewhere);

}  // namespace grader::judge
