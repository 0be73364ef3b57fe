#pragma once

#include "grader/programs/grade_class/plan.h"

#include <string>
#include <vector>

// Tells learners apart from one grading to the next, and hides their names in an anonymous class.

namespace grader::programs {

// 16 characters that nobody can foresee.
std::string random_text();

// Gives every submission of the plan a number in place of its name, which only who has the plan can turn back. A
// learner keeps it in every later plan in `out`, and in those that compare with it. What the intake says of a
// submission then names no file either. Throws pt::Error if `out` has reports that show names.
void hide_names(ClassPlan& plan, const std::string& out);

// The name of each learner of the plan in the grading that it compares with, in the plan's order; empty for who
// was not in it. Learners are the same by what their platform calls them, else by name.
std::vector<std::string> former_names(const ClassPlan& plan);

// Names in that grading as this plan may show them: hidden if only this plan hides names.
std::vector<std::string> shown_former_names(const ClassPlan& plan, std::vector<std::string> names);

// A sentence on a submission, without its folder and without the names of files, which may be a
// learner's: they stand in apostrophes.
std::string without_names(std::string sentence, const std::string& folder);

}  // namespace grader::programs
