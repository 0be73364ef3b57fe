#pragma once

#include "grader/pictures/recipes/recipes.h"

#include <cassert>
#include <cstdint>

// Goldens and submissions never have the same seed: they would share their noise, and a wrong
// picture could be too close to the golden. The highest bit tells the seeds apart.

namespace grader::pictures {

inline constexpr std::uint64_t kGoldenSeeds = std::uint64_t{1} << 63;

// The seed of the part-th slice (or run, for adaptive recipes) of a recipe's golden: different for every
// recipe and part.
constexpr std::uint64_t golden_seed(const Recipe& recipe, std::uint32_t part) {
  assert(recipe.seed < kGoldenSeeds >> 32);
  return kGoldenSeeds | recipe.seed << 32 | part;
}

// The seed of a render that is judged, from any number that its submission, recipe, round and batch
// determine.
constexpr std::uint64_t judged_seed(std::uint64_t number) { return number & ~kGoldenSeeds; }

}  // namespace grader::pictures
