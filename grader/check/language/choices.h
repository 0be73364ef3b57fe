#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

// The source of the generators' numbers (grader/check/generators/generators.h). Usually that is RapidCheck's
// random numbers. A search for bad inputs (grader/check/language/bad_inputs.h) gives them its own list instead, so
// that it can change one number and keep the others (MacIver and Hatfield-Dodds 2019, Hypothesis: A
// New Approach to Property-Based Testing).

namespace grader::check {

// Numbers in [0, 1), in the order in which generators take them.
struct Choices {
  std::vector<double> numbers;
  std::size_t taken = 0;
};

// From now on, generators take their numbers from these; nullptr: from RapidCheck. If the list is
// too short, RapidCheck's numbers are added to it.
void choose_from(Choices* choices);

// From now on, generators make simple values only: numbers of one digit, whole numbers near their lower end, directions along
// an axis.
void choose_simply(bool simply);

// The next number of the list. `random` is used where there is none.
double next_choice(std::uint64_t random);

}  // namespace grader::check
