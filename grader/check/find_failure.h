#pragma once

#include "grader/results/results.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

// Random inputs for a property, and a small one for which it fails. The private parts of RapidCheck
// (rc::detail) are used in find_failure.cpp and nowhere else: its public functions neither hand over
// the failing input nor end a search.

namespace grader::check {

struct Search {
  std::uint64_t seed = 0;  // of all inputs
  int cases = 0;           // at most
  bool shrinks = true;     // looks for a smaller input, for a bounded time
};

struct Found {
  std::optional<results::Failure> failure;  // on the smallest input found; none if all cases held
  int run = 0;                              // of the property, counted from 1, that failed on it
  std::string fault;  // what is wrong with the property itself, as where it has no inputs
};

Found find_failure(const std::function<void()>& property, const Search& search);

// Does the same search again, and stops a debugger (at_smallest_failure) just before the run.
void run_again(const std::function<void()>& property, const Search& search, int run);

// The place where a debugger stops (./run debug).
[[gnu::noinline]] void at_smallest_failure();

}  // namespace grader::check
