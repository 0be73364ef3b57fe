#pragma once

#include "grader/pictures/recipes/render.h"

namespace grader::pictures {

// The files by which one recipe is judged, and those that keep what was rendered.
struct PictureFiles {
  std::string golden;  // an EXR, made by bless
  std::string rates;   // of an adaptive recipe: the reference of its sample map
  // These files are written, unless a name is empty: mean and variance of the submission's picture
  // (EXR), the evidence (EXR), and for an adaptive recipe the samples per pixel of the submission,
  // and of the reference.
  std::string render, evidence, counts, golden_counts;
};

// The settings for rendering a recipe that is judged.
struct Rendering {
  RowRenderer rows;
  pt::Engine engine = pt::Engine::wide;  // of the scene, unless a worker runs all tasks
  SeedSource source;
  int max_rounds = 3;
};

// Returns the verdict. Throws pt::Error if a golden is missing.
results::PictureResult judge_recipe(const Recipe& recipe, const Rendering& rendering,
                                    const PictureFiles& files);

}  // namespace grader::pictures
