#pragma once

#include "grader/mistakes/known.h"

#include <set>
#include <string>
#include <vector>

namespace grader::mistakes {

// All that is known about a task that fails.
struct Evidence {
  Answers answers;               // to the battery
  std::set<std::string> broken;  // promises, but for bonus ones
  std::set<std::string> kept;
};

// Returns whether the mistake alone explains all of the evidence: its answers agree everywhere, it
// breaks what is broken, and nothing else.
bool explains(const Fingerprint& mistake, const Evidence& evidence);

// The mistake that alone explains the evidence, or several that no battery can tell apart: three at
// most. Nothing if none explains it, if mistakes of different kinds do, or if the answers are those
// of the reference: a wrong name costs a learner hours.
std::vector<const Fingerprint*> name_by_battery(const KnownTask& known, const Evidence& evidence);

}  // namespace grader::mistakes
