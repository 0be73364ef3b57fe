#pragma once

#include "grader/pictures/recipes/recipes.h"
#include "grader/pictures/statistics/image_verdict.h"
#include "grader/results/results.h"
#include "pt/render/render_rows.h"

#include <cstdint>
#include <functional>
#include <string>

namespace grader::pictures {

// Renders the rows that are asked for: in a worker (worker_rows.h), or pt::render_rows with the
// tasks that this program links.
using RowRenderer = std::function<pt::PictureRows(const pt::View&, const pt::RowsRequest&)>;

// A worker made no picture. The text says what it did instead, for a person to read.
struct NoPicture {
  results::Cause cause = results::Cause::crash;
  std::string text;
};

// The source of a picture's random numbers: the submission's content, so that the same files always
// get the same numbers, and other numbers can be tried only by changing the files.
struct SeedSource {
  std::string content;     // a hash of what is judged
  std::uint64_t seed = 1;  // of the run
};

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

// The result of a verdict on a recipe's picture; the judged render and its evidence are written into their files. And the result without a picture.
results::PictureResult described(const Recipe& recipe, const PictureFiles& files,
                                 const ImageVerdict& verdict);
results::PictureResult described(const Recipe& recipe, const PictureFiles& files,
                                 const NoPicture& none);

}  // namespace grader::pictures
