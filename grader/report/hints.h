#pragma once

#include <array>
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

}  // namespace grader::report
