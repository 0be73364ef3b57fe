#pragma once

#include "grader/judge/findings.h"
#include "grader/mistakes/known.h"

#include <optional>

namespace grader::judge {

// What a task answers to its battery, unless the same was asked before. The seed is of the draws,
// `draws` how many times the usual number. Nothing if the program that asks fails. Safe from any
// thread.
std::optional<mistakes::Answers> ask_battery(const Builder& builder, const Trial& trial,
                                             std::uint64_t seed, int draws);

}  // namespace grader::judge
