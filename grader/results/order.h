#pragma once

#include "grader/results/results.h"

#include <vector>

namespace grader::results {

// The most telling failure first. Between tasks, smaller comes first; where two are equal, the
// course decides:
//   - a task whose mistake is named: that one sentence explains all that fails;
//   - a crash, whose cause is certain and which hides everything after it;
//   - a file that does not compile, or is rejected: nothing else is known of that task;
//   - no answer in time; then an answer that is wrong; then a picture.
int importance(const TaskResult& task);

// Puts the failure of a promise first that is shown: found by itself, a crash before wrong numbers, on simple values, exact, with a
// short input; between inputs of about one length, that of the first check.
void put_most_telling_first(std::vector<Failure>& failures);

// The promises of a task that are not kept, the most telling first. Decided by, in this order:
//   - bonus promises last;
//   - a crash before an answer that takes too long or makes no sense, these before wrong numbers, and
//   last what was not called, because of the others; an answer that is not a number only leads where the
//   next line agrees, give or take a tenth: one of many wrong answers may happen to be none;
//   - the promise that the most alike known mistake breaks: the others are often only touched;
//   - if more than three of four promises are broken, all have one cause: likeness counts in tenths, then
//   the contract's order decides;
//   - exact answers before means of many draws: one input shows the fault, and no noise is in it;
//   - a promise of which more than half of the checks fail before others;
//   - what fails on simple values, then what fails at the first inputs, before what fails rarely;
//   - a short input before a long one;
//   - the contract's order, which goes from what is basic to what is special.
std::vector<const PromiseResult*> by_importance(const TaskResult& task);

// The tasks with faults, the most telling first.
std::vector<const TaskResult*> by_importance(const Results& results);

// The task to work on: the most telling of those with faults, or else the first that is not written. Null if there is neither.
const TaskResult* next_task(const Results& results);

}  // namespace grader::results
