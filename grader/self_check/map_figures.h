#pragma once

#include "grader/pictures/recipes.h"

#include <string>
#include <vector>

namespace grader::self_check {

// The difference of a sample map from the reference's (SampleMapVerdict).
struct MapFigures {
  bool pass = false;
  double ratio = 0, a = 0, b = 0, correlation = 0;
};

// The figures of the counts in a file (pt/image/sample_map.h) against the reference's in another.
MapFigures figures_of(const std::string& counts, const std::string& rates);

// The figures of one run of the reference itself for each chance to survive, against 64 runs with .7, with
// light of up to five bounces: the recipes have direct light alone, in which nobody dies.
inline constexpr int kSurvivalRuns = 64, kSurvivalBounces = 5;
std::vector<MapFigures> figures_of_survivals(pictures::Recipe recipe,
                                             const std::vector<double>& survivals);

}  // namespace grader::self_check
