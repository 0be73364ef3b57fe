#pragma once

#include "grader/service/sandbox/box.h"

#include <optional>
#include <string>

namespace grader::sandbox {

// The isolation of submissions from the machine, and its description for every report: "A:
// bubblewrap with seccomp in it". For C, it says why nothing better works here.
struct Isolation {
  Tier tier = Tier::limits;
  std::string words;
  std::string why_not_better;  // why each better tier does not work here; empty for A
};

// The meaning of each letter, without trying the tiers.
const char* describe(Tier tier);

// Finds the best tier that works here, or tests the `forced` tier, with a small program. It must be
// unable to read `root`/CMakeLists.txt and able to write in a new folder in `work`, and it reports
// all other protections. Takes some 20 ms. Throws pt::Error if the forced tier does not work.
Isolation probe_isolation(const std::string& root, const std::string& work,
                          std::optional<Tier> forced = {});

}  // namespace grader::sandbox
