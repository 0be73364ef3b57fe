#pragma once

#include "grader/sandbox/box.h"

#include <optional>
#include <string>

namespace grader::sandbox {

// The isolation of submissions from the machine, and its description for every report: "A:
// bubblewrap with seccomp in it". For C, the words say why nothing better works here.
struct Isolation {
  Tier tier = Tier::limits;
  std::string words;
  std::string why_not_better;  // why each better tier does not work here; empty for A
};

// The meaning of each letter, where nothing has been tried.
const char* describe(Tier tier);

// Finds the best tier that works here, or the one that is `forced`, by running a small program in
// it: which must not get at `root`/CMakeLists.txt, must be able to write in a new folder in `work`,
// and says what else holds. Takes some 20 ms. Throws pt::Error if the forced one does not work.
Isolation probe_isolation(const std::string& root, const std::string& work,
                          std::optional<Tier> forced = {});

}  // namespace grader::sandbox
