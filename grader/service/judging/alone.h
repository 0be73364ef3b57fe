#pragma once

#include "grader/service/judging/findings.h"
#include "grader/service/judging/grade.h"

#include <functional>

namespace grader::judging {

// A task on its way to a verdict.
struct Judged {
  const build::TaskConfig* config = nullptr;
  build::Built object;       // of the submission's file, if it compiles
  std::string content;       // a hash of the file, equal on every machine
  bool right_alone = false;  // keeps all promises, with the reference elsewhere
  bool settled = false;      // every promise is decided: alone, and together if needed
  results::TaskResult result;
};

// A task before any verdict: its promises, as the contract lists them.
Judged not_judged(const build::Config& config, const build::TaskConfig& task);

// Reads and compiles the file of each task. Sets an object, or a state that explains why there is
// none.
void compile_all(const build::Builder& builder, const GradeRequest& request,
                 std::vector<Judged>& judged);

// Judges each task alone: the submission's task, with the judge's answers or the reference in all
// other places. Sets its state. A task that passes here is right alone. `progress` is called after
// every task, by one thread at a time.
void judge_alone(const build::Config& config, const build::Builder& builder,
                 const GradeRequest& request, std::vector<Judged>& judged,
                 const std::function<void()>& progress);

// Adds findings to a result: the state, and every failure with the command that replays it.
void enter(const results::TaskResult& found, const GradeRequest& request,
           results::TaskResult& result);

// The parts of one task's worker: the task, and in all other places the judge's answers (for
// properties) or the reference (for pictures).
enum class Elsewhere { answers, reference };
build::Built link_alone(const build::Config& config, const build::Builder& builder,
                        const Judged& judged, Elsewhere elsewhere);

}  // namespace grader::judging
