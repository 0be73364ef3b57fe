#pragma once

#include "grader/service/classes/plan.h"

#include <string>
#include <vector>

// Recognises learners from one grading to the next, and hides their names in an anonymous class.

namespace grader::classes {

// 16 unpredictable characters.
std::string random_text();

// Replaces the name of every submission of the plan by a number; only the plan can turn it back. A
// learner keeps the number in later plans in `out`, and in plans that compare with them. Messages
// of the intake then name no file either. Throws pt::Error if `out` has reports that show names.
void hide_names(ClassPlan& plan, const std::string& out);

// The name that each learner of the plan had in the earlier grading, in the plan's order; empty for
// a learner who was not in it. Learners are matched by their platform's ID, else by name.
std::vector<std::string> former_names(const ClassPlan& plan);

// Names of the earlier grading as this plan may show them: hidden if only this plan hides names.
std::vector<std::string> shown_former_names(const ClassPlan& plan, std::vector<std::string> names);

// A sentence about a submission, without its folder and file names, which may contain a learner's
// name. File names are recognised by their apostrophes.
std::string without_names(std::string sentence, const std::string& folder);

}  // namespace grader::classes
