#pragma once

#include "grader/judge/alone.h"

namespace grader::judge {

// The verdict on a task at any time of the run. Its state is a fault as soon as one is
// known; otherwise not_judged until all that judges it has been. A promise counts as kept only when
// it has been judged by itself and with the submission's other tasks.
results::TaskResult so_far(const Judged& judged);

}  // namespace grader::judge
