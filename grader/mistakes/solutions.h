#pragma once

#include <string>
#include <vector>

// All solutions of a task that are kept: its right solutions, and its known mistakes except guards. One program contains them
// all and acts as the one whose number it gets (cmake/mistakes.cmake); solutions.<slug>.txt says what each number is.

namespace grader::mistakes {

struct Solution {
  std::string name;         // "absolute_epsilon", "right.textbook"
  std::string breaks;       // the promise that it breaks; empty if it is right
  bool is_ordinary = true;  // ordinary inputs show the mistake

  bool is_right() const { return breaks.empty(); }
};

// Reads that table, in the order of the numbers. Throws pt::Error if it is missing or anything else.
std::vector<Solution> read_solutions(const std::string& path);

// ordinary.<slug>.txt has the names of the mistakes that ordinary inputs show. Without this file, all of them are ordinary.
void mark_ordinary(std::vector<Solution>& solutions, const std::string& path);

}  // namespace grader::mistakes
