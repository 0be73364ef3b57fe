#pragma once

#include "grader/mistakes/answers.h"

#include <string>
#include <vector>

// The known mistakes of a task (grader/tasks/<slug>/mistakes.txt), with their answers to its battery. The build runs
// the battery (grader/programs/know.cpp) and keeps the answers in known.<slug>.json, which contains none of their code.

namespace grader::mistakes {

struct Fingerprint {
  std::string name;      // "absolute_epsilon"
  std::string breaks;    // the promise that it breaks
  std::string sentence;  // says what is wrong
  std::string hint;      // leads to the line
  Answers answers;

  bool operator==(const Fingerprint&) const = default;
};

struct KnownTask {
  Answers right;  // the reference's answers
  std::vector<Fingerprint> mistakes;

  bool operator==(const KnownTask&) const = default;
};

// Reads the comment above a mistake's code (cmake/edits.awk). The result has no answers.
Fingerprint described(const std::string& name, const std::string& code);

// Answers that cannot be distinguished from the right ones are left out of the text.
std::string to_json(const KnownTask& known);
// Reads this text. Throws pt::Error, with the name `path`, for any other text.
KnownTask known_from_json(const std::string& text, const std::string& path);

}  // namespace grader::mistakes
