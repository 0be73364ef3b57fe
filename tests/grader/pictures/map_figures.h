#pragma once

#include "grader/pictures/recipes/recipes.h"

#include <string>
#include <vector>

namespace grader::tests {

// The difference between a sample map and the reference's (SampleMapVerdict).
struct MapFigures {
  bool pass = false;
  double ratio = 0, a = 0, b = 0, correlation = 0;
};

// Compares the counts in a file (pt/image/sample_map.h) with the reference's in another file.
MapFigures figures_of(const std::string& counts, const std::string& rates);

// The figures of one run of the reference for each survival probability, against 64 runs at .7. It
// has five bounces: the recipes show direct light alone, where roulette never ends a path.
inline constexpr int kSurvivalRuns = 64, kSurvivalBounces = 5;
std::vector<MapFigures> figures_of_survivals(pictures::Recipe recipe,
                                             const std::vector<double>& survivals);

}  // namespace grader::tests
