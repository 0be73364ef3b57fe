#pragma once

#include "grader/pictures/render.h"

namespace grader::pictures {

// The files by which one recipe is judged, and those that keep what was rendered.
struct PictureFiles {
  std::string golden;  // an EXR, made by bless
  std::string rates;   // of an adaptive recipe: the reference of its sample map
  // Written: mean and variance of the submission's picture, an EXR; the evidence, another; and for
  // an adaptive recipe the samples per pixel that it took, and that the reference takes. Empty: not
  // written.
  std::string render, evidence, counts, golden_counts;
};

// The settings for rendering a recipe that is judged.
struct Rendering {
  RowRenderer rows;
  pt::Engine engine = pt::Engine::wide;  // of the scene, unless a worker runs all tasks
  SeedSource source;
  int max_rounds = 3;
};

// The verdict. Throws pt::Error for goldens that are not there.
results::PictureResult judge_recipe(const Recipe& recipe, const Rendering& rendering,
                                    const PictureFiles& files);

}  // namespace grader::pictures
