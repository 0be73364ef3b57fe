#pragma once

#include "grader/mistakes/known.h"

#include <set>
#include <string>
#include <vector>

namespace grader::mistakes {

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

}  // namespace grader::mistakes
