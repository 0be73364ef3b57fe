#pragma once

#include "grader/pictures/recipes/recipes.h"
#include "grader/pictures/statistics/sample_map_verdict.h"
#include "pt/image/sample_map.h"

#include <filesystem>
#include <functional>

// The verdict on the sample map of somebody else's adaptive picture: one map, and the settings that it was made with.

namespace grader::pictures {

// Reads counts: a .csv of pt::write_counts, or a picture in the colours of the course, from blue (none) by green (half of the maximum) to red
// (the maximum). 8 bits hold a count to a few samples, so one beside a multiple of the batch counts as that. Throws pt::Error for other colours.
pt::SampleMap read_rates(const std::filesystem::path& file, const pt::AdaptiveSettings& settings);

// The colour of a count in the course's maps.
pt::Color8 course_color(int count, int max);

// The rules of judge_sample_map are made for settings with which one map says much. With others the reference's own maps break them, too. So
// a map is wrong if it breaks a rule and is not like them; if it is like them, nothing can be said.
struct RatesVerdict {
  enum class Outcome { agrees, wrong, cannot_say };
  Outcome outcome = Outcome::agrees;
  SampleMapVerdict map;
};

// Compares the map with this number of runs of the reference. `recipe` is adaptive. `progress` gets the part done, in [0, 1].
inline constexpr int kRunsOfRates = 16;
RatesVerdict judge_rates(const pt::SampleMap& map, const Recipe& recipe, int threads,
                         const std::function<void(double)>& progress);

}  // namespace grader::pictures
