#pragma once

#include "grader/programs/grade_class/plan.h"
#include "grader/report/compare_page.h"

#include <string>

namespace grader::programs {

// The reports of the plan's submissions in `out`, compared with those of an earlier grading. Which are
// the same is in the plan; results that are not complete count as none.
report::Comparison compare(const ClassPlan& plan, const std::string& former,
                           const std::string& out);

}  // namespace grader::programs
