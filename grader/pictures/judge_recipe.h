#pragma once

#include "grader/pictures/render.h"

namespace grader {

// What one recipe is judged by, and where what was seen is kept.
struct PictureFiles {
  std::string golden;  // an EXR, made by bless
  std::string rates;   // of an adaptive recipe: the reference of its sample map
  // Written: mean and variance of the submission's picture, an EXR; the evidence, another; and for
  // an adaptive recipe the samples a pixel that it took, and that the reference takes.
  std::string render, evidence, counts, golden_counts;
};

// The recipe as the session's worker renders it, judged. Engine: of the scene, unless the worker
// runs all tasks. Of at most `max_stages` stages. Throws pt::Error for goldens that are not there.
PictureResult judge_recipe(const Recipe& recipe, pt::Engine engine, const SeedSource& source,
                           int max_stages, const PictureFiles& files);

}  // namespace grader
