#pragma once

#include "grader/service/classes/plan.h"
#include "grader/service/platforms/compare_page.h"

#include <string>

namespace grader::classes {

// Compares the reports in `out` with the reports of an earlier grading. The plan says which
// submissions belong together. Incomplete results are left out.
platforms::Comparison compare(const ClassPlan& plan, const std::string& former,
                              const std::string& out);

}  // namespace grader::classes
