#pragma once

#include "grader/mistakes/answers.h"

#include <map>
#include <string>
#include <vector>

// The mistakes that are known: how each wrong solution (grader/tasks/*/wrong) shows. One file,
// grader/mistakes/known.json, made by the program known_mistakes; the solutions themselves are not
// in it.

namespace grader::mistakes {

// The answers and broken promises of one wrong solution.
struct Fingerprint {
  std::string name;                 // of its file: "absolute_epsilon"
  std::string sentence;             // that says the mistake
  std::string source;               // a hash of the file
  std::vector<std::string> broken;  // promises, at every seed that was tried; no bonus
  std::vector<std::string> unsure;  // at some of them
  Answers answers;

  bool operator==(const Fingerprint&) const = default;
};

struct KnownTask {
  std::string battery;  // a hash of what asked
  Answers right;        // of the reference
  std::vector<Fingerprint> mistakes;

  bool operator==(const KnownTask&) const = default;
};

using KnownMistakes = std::map<std::string, KnownTask>;  // by slug

// Answers that are as the right ones are left out of the text.
std::string to_json(const KnownMistakes& known);
// Throws pt::Error, naming `path`, for anything else.
KnownMistakes known_from_json(const std::string& text, const std::string& path);

}  // namespace grader::mistakes
