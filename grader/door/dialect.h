#pragma once

#include "grader/door/clone.h"
#include "grader/results/results.h"

#include <filesystem>
#include <map>
#include <string>

namespace grader::door {

// The course's view of a promise of ours.
enum class Change {
  dropped,  // it asks for something else, so the promise is not judged
  bonus,    // it does not ask for it
  slower,   // it allows it, and programs that do not keep the promise are slower, not wrong
};

// A course, where it does not ask for what our contracts ask for.
struct Dialect {
  std::string name;                                                 // "CS184, 2022 and later"
  std::map<std::string, std::map<std::string, Change>> promises{};  // by slug, by promise
  std::map<std::string, std::string> functions{};                   // by slug: the learner's names
};

// The dialect of the clone's years: grader/door/dialects/2022.json. `texts` is the folder
// grader/door.
//   {"name": "...", "tasks": {slug: {promise: ["dropped" | "bonus" | "slower", why]}}}
// Throws pt::Error, with the file and what to do, for anything else.
Dialect load_dialect(const std::filesystem::path& texts, Generation generation);

// The same with our contracts, unchanged: only the names are the learner's.
Dialect no_dialect(const std::filesystem::path& texts, Generation generation);

// Returns whether the promise is not judged.
bool is_dropped(const Dialect& dialect, const std::string& slug, const std::string& promise);

// Makes a result that lists the promises of the contract one that lists those of the dialect.
void translate(const Dialect& dialect, results::TaskResult& task);

}  // namespace grader::door
