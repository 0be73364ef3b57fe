#pragma once

#include "grader/service/wire/session.h"

#include <string>

#include <gtest/gtest.h>

namespace grader::programs {

// Writes the findings of a property program as a results.json (docs/results.md) with the one task
// of the session: its state, its promises with name, held, seconds and failures, its output, and
// whether it keeps a variable between calls. Fields that only the program `grade` can fill, such as
// words, points and replay, are left empty. Throws pt::Error if the file cannot be written.
void write_report(const std::string& path, const testing::UnitTest& test,
                  const wire::SessionSettings& settings, const wire::SessionRecord& record);

}  // namespace grader::programs
