#pragma once

#include "grader/mistakes/naming.h"

#include <map>
#include <string>
#include <vector>

namespace grader::self_check {

// Counts how many known mistakes are named right: kept solutions are handed in as submissions.
class Score {
 public:
  // Adds a solution of the kind "wrong", "right", "reference" or "variation"; the name is that of the mistake it makes.
  void add(const mistakes::KnownTask& known, const std::string& slug, const std::string& kind,
           const std::string& name, const mistakes::Evidence& evidence);

  // A table with a line per task; with `verbose` also a line for each that was not named right.
  std::string text(bool verbose) const;

  // Wrong names given to anything that was handed in whole.
  int misnamed() const;

  // The share of the wrong solutions that fail.
  double share_named() const;

  // The share of those that get the name of another kind of mistake when they are not known.
  double share_left_out() const;

 private:
  struct Counts {
    int wrong = 0, named = 0, alone = 0, misnamed = 0, passing = 0, unseen = 0, ambiguous = 0;
    int right = 0, right_named = 0;
    int varied = 0, varied_named = 0;  // rightly
    int left_out = 0;                  // misnamed when its own fingerprint is taken away
  };
  void add_wrong(const mistakes::KnownTask& known, const std::string& name,
                 const mistakes::Evidence& evidence, const std::string& slug);
  void add_variation(const mistakes::KnownTask& known, const std::string& name,
                     const mistakes::Evidence& evidence, const std::string& slug);

  std::map<std::string, Counts> tasks_;
  std::vector<std::string> lines_;
};

}  // namespace grader::self_check
