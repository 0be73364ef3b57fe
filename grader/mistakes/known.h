#pragma once

#include "grader/mistakes/answers.h"

#include <map>
#include <string>
#include <vector>

// The known mistakes: the answers and broken promises of each wrong solution
// (grader/tasks/*/wrong). They are kept in one file, grader/mistakes/known.json, which the program
// known_mistakes makes. The file does not contain the solutions themselves.

namespace grader::mistakes {

// The answers and broken promises of one wrong solution.
struct Fingerprint {
  std::string name;                 // the name of its file: "absolute_epsilon"
  std::string sentence;             // describes the mistake
  std::string source;               // a hash of the file
  std::vector<std::string> broken;  // promises that fail at every seed that was tried; no bonus
  std::vector<std::string> unsure;  // promises that fail at some of these seeds
  Answers answers;

  bool operator==(const Fingerprint&) const = default;
};

struct KnownTask {
  std::string battery;  // a hash of the files of the battery
  Answers right;        // the reference's answers
  std::vector<Fingerprint> mistakes;

  bool operator==(const KnownTask&) const = default;
};

using KnownMistakes = std::map<std::string, KnownTask>;  // by slug

// Answers that cannot be distinguished from the right ones are left out of the text.
std::string to_json(const KnownMistakes& known);
// Reads this text. Throws pt::Error, with the name `path`, for any other text.
KnownMistakes known_from_json(const std::string& text, const std::string& path);

}  // namespace grader::mistakes
