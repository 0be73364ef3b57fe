#pragma once

#include "grader/results/results.h"

#include <string>

namespace grader::report {

// The results as JUnit's XML, for continuous integration: a testsuite per task, a testcase per
// promise or a picture. A promise that is not kept, or a picture that is not right, has a failure
// with its text in it; a crash, a timeout or a rejected file is an error; a task that was not
// attempted, is blocked, or is not judged yet is skipped, and so is a bonus promise that is not
// kept. An unfinished run has a suite with an error that says so.
std::string to_junit(const results::Results& results);

}  // namespace grader::report
