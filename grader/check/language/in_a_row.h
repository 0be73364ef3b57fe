#pragma once

#include "grader/check/language/property.h"
#include "pt/sampling/sampler.h"

#include <cstdint>
#include <functional>

namespace grader::check {

// A call of a task that draws random numbers, with all other arguments fixed. It returns the answer
// as a colour.
using Drawing = std::function<pt::Rgb(pt::Sampler&)>;

// Calls the task many times in a row, with one sampler. The case fails unless
// - the sampler goes on: every call changes its state,
// - the calls are independent: calls that follow each other, or are up to 32 calls apart, are not
//   correlated,
// - nothing else is random or remembered: a sampler in the state of the first call gives its answer
//   again.
// The arguments must make the answer random. Returns the answers.
std::vector<pt::Rgb> expect_goes_on(std::uint64_t seed, const Drawing& task);

// Calls the task with some samplers. The case fails unless each call changes the state of its sampler:
// also a call that finds no light, or a path that leaves the scene.
void expect_moves_on(std::uint64_t seed, const Drawing& task);

// The correlation of two channels of the same answers, from -1 to 1; 0 if one of them never varies.
double correlation(const std::vector<pt::Rgb>& answers, int a, int b);

}  // namespace grader::check
