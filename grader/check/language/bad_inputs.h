#pragma once

#include "grader/check/language/show.h"

#include <cstdint>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

// A search for the inputs on which a task is furthest from an exact oracle: extended precision, brute
// force, a closed form. It draws from the generators of the properties, and then changes the worst
// inputs that it has found, one to three numbers at a time. The searches of a task are in
// grader/tasks/<task>/searches.cpp:
//
//   SEARCH(hit_sphere, point_off_the_sphere) {
//     return {.title = "...", .badness = [] { const Chord c = *chord(From::outside); ... }};
//   }

namespace grader::check {

struct BadInputs {
  std::string title;
  std::string measure;  // the quantity, and the meaning of 1: usually the contract's limit
  // Tries one input: draws from generators, calls the task, and returns how bad its answer is, at
  // least 0. It returns kBroken if the answer is wrong whatever the size of its error.
  std::function<double()> badness;
};

inline constexpr double kBroken = 1e9;

// Keeps the text of the input if this run shows it. badness() calls this function.
void show_input(const std::function<std::string()>& text);

// The same for a case of a property, with its showValue, and for single values, one per line.
template <class Case>
void show_case(const Case& c) {
  show_input([&] {
    std::ostringstream out;
    showValue(c, out);
    return out.str();
  });
}
template <class First, class... Others>
requires(sizeof...(Others) > 0) void show_case(const First& first, const Others&... others) {
  show_input([&] {
    std::ostringstream out;
    show_lines(out, first, others...);
    return out.str();
  });
}

struct NamedSearch {
  std::string name;
  BadInputs search;
};
const std::vector<NamedSearch>& searches();

struct SearchSettings {
  std::uint64_t seed = 1;
  double seconds = 60;                        // of all searches of the program together
  std::string file;                           // keeps the results for a later search
  std::function<void()> begin;                // before each piece of about a second
  std::function<void(double)> progress = {};  // gets the part that is done
};

// Runs the searches in turns and keeps the results in the file, as JSON: the number of inputs and
// of seconds, and the worst inputs as text, with their badness.
void run_searches(const SearchSettings& settings);

// Used by SEARCH.
bool keep_search(const char* name, BadInputs (*make)());

}  // namespace grader::check

#define SEARCH(task, name)                                         \
  static ::grader::check::BadInputs search_##task##_##name();      \
  static const bool kept_search_##task##_##name =                  \
      ::grader::check::keep_search(#name, search_##task##_##name); \
  static ::grader::check::BadInputs search_##task##_##name()
