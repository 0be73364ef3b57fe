#pragma once

#include "grader/pictures/recipes/judge_recipe.h"
#include "grader/renderers/renderer.h"
#include "pt/image/film.h"

#include <filesystem>
#include <functional>

// The verdict on a renderer that somebody else wrote, by the statistics of docs/verdicts.md.

namespace grader::renderers {

// The noise of our own render decides how many samples a verdict needs: few of them carry the light if the mean of variance over
// squared mean, of one sample, is above this. The recipes of scenes/recipes.json that are noisy lie above it.
inline constexpr double kNoisyVariance = 40;
pictures::NoiseClass noise_class_of(const pt::Film& golden);

// A renderer that draws its light samples in another way than ours may be right and have far more noise. It is asked for so many times the samples that its noise is like
// ours, up to this.
inline constexpr int kMostTimesTheSamples = 64;

// Renders the golden of a recipe with the reference, or finds it in `folder`.
pt::Film golden_of(const pictures::Recipe& recipe, const std::filesystem::path& folder, int threads,
                   const std::function<void(double)>& progress);

// Judges the renderer on the recipe's picture, round by round until that is decided. `scene` is the file that it reads: the
// recipe's, or the same in another format. The seeds come from the command and the recipe alone. Renders and evidence are written into `files`.
results::PictureResult judge_renderer(const pictures::Recipe& recipe, const pt::Film& golden,
                                      const OtherRenderer& renderer,
                                      const std::filesystem::path& scene,
                                      const pictures::PictureFiles& files);

}  // namespace grader::renderers
