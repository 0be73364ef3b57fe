#pragma once

#include "grader/wire/session.h"

#include <string>

#include <gtest/gtest.h>

namespace grader::programs {

// Writes what a property program found, for `grade` (grader/judge/findings.h):
//   {"promises": [{"name", "held", "seconds", "failures": [{"input", "what", "got", "expected",
//     "off_by", "cause", "cases_before", "seed"}]}],
//    "todo": [slug], "printed": text, "kept": n, "calls": n, "restarts": n}
// Throws pt::Error if the file cannot be written.
void write_report(const std::string& path, const testing::UnitTest& test,
                  const wire::SessionRecord& record);

}  // namespace grader::programs
