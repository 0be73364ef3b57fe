#pragma once

#include "grader/mistakes/known.h"
#include "grader/service/judging/findings.h"

#include <optional>

namespace grader::judging {

// A task's answers to its battery, from the cache if possible. `seed` is for the random draws;
// their number is `draws` times the usual number. Nothing if the program fails. Safe from any
// thread.
std::optional<mistakes::Answers> ask_battery(const build::Builder& builder, const Trial& trial,
                                             std::uint64_t seed, int draws);

}  // namespace grader::judging
