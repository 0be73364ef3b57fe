#pragma once

#include "grader/judge/findings.h"
#include "grader/mistakes/known.h"

#include <optional>

namespace grader::judge {

// A task's answers to its battery; those of an earlier run are used again. The seed is of the
// draws, `draws` how many times the usual number. Nothing if the program that asks fails. Safe from
// any thread.
std::optional<mistakes::Answers> ask_battery(const Builder& builder, const Trial& trial,
                                             std::uint64_t seed, int draws);

}  // namespace grader::judge
