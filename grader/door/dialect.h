#pragma once

#include "grader/door/clone.h"
#include "grader/door/texts.h"
#include "grader/results/results.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace grader::door {

// The course's view of a promise of ours.
enum class Change {
  dropped,  // it asks for something else, so the promise is not judged
  bonus,    // it does not ask for it
  slower,   // it allows it, and programs that do not keep the promise are slower, not wrong
};

// A promise that only work in the skeleton of a course can keep: what it is about is not in our
// contracts. An adapter prints a line if it is not kept.
struct OwnPromise {
  std::string name{}, words{};
};

// A course, where it does not ask for what our contracts ask for.
struct Dialect {
  std::string name;               // "CS184, 2022 and later"
  bool single_precision = false;  // sums and statistics of floats are right
  std::map<std::string, std::map<std::string, Change>> promises{};  // by slug, by promise
  std::map<std::string, std::string> functions{};                   // by slug: the learner's names
  std::map<std::string, std::vector<OwnPromise>> own{};             // by slug
  std::map<std::string, Adapter>
      adapters{};  // by slug: causes, names, and the other task of a pair
};

// The dialect of the clone's years: grader/door/dialects/2022.json. `texts` is the folder
// grader/door.
//   {"name": "...", "single_precision": why, "tasks": {slug: {promise: ["dropped" | "bonus" | "slower", why]}}}
// Throws pt::Error, with the file and what to do, for anything else.
Dialect load_dialect(const std::filesystem::path& texts, const Course& course);

// The same with our contracts, unchanged: only the names are the learner's.
Dialect no_dialect(const std::filesystem::path& texts, const Course& course);

// Returns whether the promise is not judged.
bool is_dropped(const Dialect& dialect, const std::string& slug, const std::string& promise);

// Returns whether the promise is one of the dialect alone.
bool is_own(const Dialect& dialect, const std::string& slug, const std::string& promise);

// Makes a result that lists the promises of the contract one that lists those of the dialect.
void translate(const Dialect& dialect, results::TaskResult& task);

// Enters which of the dialect's own promises are kept by a task that was judged, and which mistake was
// seen, from what it printed. The submission could have printed it: so a promise can only be lost by
// it, and a mistake has a name, and costs what it costs. `replay` is the command that shows it again.
void settle_own(const Dialect& dialect, const std::string& printed, const std::string& replay,
                results::TaskResult& task);

// The text that a task printed, without the lines of the adapter.
std::string without_notes(const std::string& printed);

// Marks the mistake that the judge has named if it is a cause of the dialect, and all promises are broken by calls that did not end:
// then it costs one promise.
void settle_cause(const Dialect& dialect, results::TaskResult& task);

// Makes a result of `task`, which fails with the judge's version of the other task of its pair, one
// that says that it is right with the learner's own.
void works_only_together(const Dialect& dialect, const std::string& replay,
                         results::TaskResult& task);

}  // namespace grader::door
