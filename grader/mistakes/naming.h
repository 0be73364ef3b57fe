#pragma once

#include "grader/mistakes/answers.h"
#include "grader/mistakes/known.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace grader::mistakes {

// Returns whether two lists of answers to one battery may come from the same mistake. Exact numbers
// have to agree to 1e-6 of the largest number of their answer. Means may differ by chance: each one
// by five standard errors at most, and all together by no more than chance exceeds once in ten
// thousand times. Two runs of the same solution disagree less than once in a thousand times.
bool agree(const Answers& a, const Answers& b);

// Returns whether an answer need not be kept, because it cannot be distinguished from the right
// one, and is not much less certain.
bool is_as_right(const Answer& answer, const Answer& right);

// Everything that is known about a task that fails.
struct Evidence {
  Answers answers;               // the answers to the battery
  std::set<std::string> broken;  // promises, without bonus promises
};

// Returns whether the mistake explains the evidence: its answers agree to every call, and the promise that it breaks is
// broken.
bool explains(const Fingerprint& mistake, const Evidence& evidence);

// Returns the mistake that alone explains the evidence, or several that no battery can distinguish:
// three at most. Returns nothing if no mistake explains it, if mistakes with different answers do,
// or if the answers are those of the reference. A wrong name costs a learner hours.
std::vector<const Fingerprint*> name_by_battery(const KnownTask& known, const Evidence& evidence);

// Returns how alike the task is to known mistakes, for each broken promise the most alike of those that break it: from 0 to 1, the
// share of the calls with a wrong answer that have one in both. A call that few mistakes answer wrongly counts more. So it says which promise
// a mistake without a name most likely breaks, and which ones it only touches.
std::map<std::string, double> likeness(const KnownTask& known, const Evidence& evidence);

}  // namespace grader::mistakes
