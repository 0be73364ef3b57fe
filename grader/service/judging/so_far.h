#pragma once

#include "grader/service/judging/alone.h"

namespace grader::judging {

// The verdict on a task at any time of the run. Its state is a fault as soon as one is known, else
// not_judged until all its trials are done. A promise counts as kept only after it was judged both
// alone and with the submission's other tasks.
results::TaskResult so_far(const Judged& judged);

// The result without the folder in which the judge works: a program may print its own path, and so
// may the loader that refuses to start it. Paths of pictures stay.
results::TaskResult without_folder(results::TaskResult result, const std::string& folder);

}  // namespace grader::judging
