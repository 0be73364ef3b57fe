#pragma once

#include "grader/pictures/render.h"

namespace grader {

// What one recipe is judged by, and where what was seen is kept.
struct PictureFiles {
  std::string golden;     // an EXR, made by bless
  std::string reference;  // of an adaptive recipe: its sample map's
  std::string render;     // written: mean and variance of the submission's picture, an EXR
  std::string evidence;   // written: an EXR
  std::string counts;     // written for an adaptive recipe
};

// The recipe as the session's worker renders it, judged. Engine: of the scene, unless the worker
// runs all tasks. Of at most `max_stages` stages. Throws pt::Error for goldens that are not there.
PictureResult judge_recipe(const Recipe& recipe, pt::Engine engine, const SeedSource& source,
                           int max_stages, const PictureFiles& files);

}  // namespace grader
