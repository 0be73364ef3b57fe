#pragma once

#include "grader/results/results.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace grader::report {

// Hints come in steps, each giving away more than the one before. A hints.md has one heading "## "
// for each, in this order, with a general part first and then sections "### <promise in words>".
inline constexpr std::array<std::string_view, 3> kHintSteps{"Question", "Direction",
                                                            "Usual mistake"};

// The text of a step about one promise.
struct PromiseHint {
  std::string title;  // "keeps t inside the ray"
  std::string text;
};

struct HintStep {
  std::string general;
  std::vector<PromiseHint> promises;
};

using Hints = std::array<HintStep, kHintSteps.size()>;

// Throws pt::Error, naming `path` and the line, if a step is missing, out of order, twice there, or
// has an empty part.
Hints parse_hints(const std::string& text, const std::string& path);

// The step's text about a promise (the property's name), or else its general text.
const std::string& about(const HintStep& step, const std::string& promise);

// Facts about a task that `grade` keeps for `hint` and for ./run debug, and the hints given so far:
// a text file per task, in the folder hints/ below `work`, with the lines
//   seed 1
//   fails <property>            for each promise that failed, in the order of the report
//   given <step> <property>     no property: the general hint
struct Memory {
  std::uint64_t seed = 1;
  std::vector<std::string> fails;
  std::map<std::string, int> given;  // by property: the last step, counted from 1
};

// Reads the memory; empty if there is none.
Memory recall(const std::string& work, const std::string& slug);

// Writes the whole file or none. Throws pt::Error if it cannot be written.
void remember(const std::string& work, const std::string& slug, const Memory& memory);

// After a run of `grade`: remembers the promises that fail now. The hints of a task that passes
// start again.
void remember_failures(const std::string& work, const results::Results& results);

}  // namespace grader::report
