#pragma once

#include "grader/results/points.h"
#include "grader/results/results.h"
#include "grader/service/build/config.h"

#include <string>
#include <vector>

// Points for a learner's own examples (grader/points.json: examples). The program grade_examples, next to grade, judges them.

namespace grader::programs {

// The tasks among these whose examples earn points.
std::vector<std::string> with_points_for_examples(const results::Points& points,
                                                  const std::vector<std::string>& slugs);

// Judges the examples that were handed in with these tasks. Each task gets a bonus promise for each promise that has ordinary mistakes:
// it is kept if the examples catch all of them. `config_path`: grade.json. Throws pt::Error if they could not be judged.
void add_examples(const build::Config& config, const std::string& config_path,
                  const std::string& submission, results::Results& results);

}  // namespace grader::programs
