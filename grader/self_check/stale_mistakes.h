#pragma once

#include "grader/judge/config.h"
#include "grader/mistakes/known.h"

#include <string>
#include <vector>

namespace grader::self_check {

// The reasons why the known mistakes are out of date, a sentence each: a battery or a solution that
// has changed since, a solution that is not known, one that is known and not kept any more.
// Solutions that break only a bonus promise need not be known: they pass.
std::vector<std::string> out_of_date(const judge::Config& config,
                                     const mistakes::KnownMistakes& known);

}  // namespace grader::self_check
