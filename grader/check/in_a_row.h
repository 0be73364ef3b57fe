#pragma once

#include "grader/check/property.h"
#include "pt/sampling/sampler.h"

#include <cstdint>
#include <functional>

namespace grader::check {

// A task that draws random numbers, called with all its other arguments: its answer as a color.
using Drawing = std::function<pt::Rgb(pt::Sampler&)>;

// Calls the task many times in a row, with one sampler, and makes the case fail unless
// - the sampler goes on: a call leaves it in another state,
// - the calls are independent: those that follow each other are not correlated,
// - nothing else is random or remembered: a sampler in the state of the first call gives the same
//   answer again.
// The arguments must be such that an answer is random. Returns the answers.
std::vector<pt::Rgb> expect_goes_on(std::uint64_t seed, const Drawing& task);

}  // namespace grader::check
