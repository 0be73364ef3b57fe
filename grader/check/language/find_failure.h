#pragma once

#include "grader/results/results.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

// Runs a property on random inputs, and finds a small input for which it fails. The private parts
// of RapidCheck (rc::detail) are used only in find_failure.cpp: its public functions neither return
// the failing input nor stop a search.

namespace grader::check {

struct FailureSearch {
  std::uint64_t seed = 0;  // of the random inputs
  int cases = 0;           // the largest number of random inputs
  bool shrinks = true;     // looks for a smaller input
  int max_crashes = 20;    // smaller inputs after a crash, each of which costs a new process
};

struct Found {
  std::optional<results::Failure> failure;  // on the smallest input found; none if all cases held
  int run = 0;        // the run of the property that failed on it, counted from 1
  std::string fault;  // what is wrong with the property itself, for example no inputs
};

Found find_failure(const std::function<void()>& property, const FailureSearch& search);

// If a property runs now on an input that is tried only because it is smaller than one that has
// failed, returns which search tries it, counted from 1; else 0. Nothing that these runs do may
// change a verdict.
int search_for_smaller();

// Repeats the same search. A debugger stops (at_smallest_failure) just before run number `run`.
void run_again(const std::function<void()>& property, const FailureSearch& search, int run);

// The place where a debugger stops (./run debug).
[[gnu::noinline]] void at_smallest_failure();

}  // namespace grader::check
