#pragma once

#include "grader/programs/grade_class/plan.h"
#include "grader/report/compare_page.h"

#include <string>

namespace grader::programs {

// The reports of the plan's submissions in `out`, compared with those of an earlier grading. Submissions
// are the same if they have the same name; results that are not complete count as none.
report::Comparison compare(const ClassPlan& plan, const std::string& former,
                           const std::string& out);

}  // namespace grader::programs
