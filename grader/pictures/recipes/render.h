#pragma once

#include "grader/pictures/recipes/recipes.h"
#include "grader/pictures/statistics/image_verdict.h"
#include "grader/results/results.h"
#include "pt/image/sample_map.h"
#include "pt/render/render_rows.h"

#include <cstdint>
#include <functional>
#include <string>

// Renders pictures of a recipe, wherever their rows are rendered.

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

// The seed of one batch of a round; never a golden's (grader/pictures/recipes/seeds.h).
std::uint64_t batch_seed(const SeedSource& source, const Recipe& recipe, int round, int batch);

struct Rendered {
  pt::Image mean;        // as the task returned it, NaN included
  pt::SampleMap counts;  // of an adaptive recipe; else empty
};

Rendered render(const Recipe& recipe, const pt::View& view, const RowRenderer& rows, int samples,
                std::uint64_t seed);

// Renders the batches of one round. For an adaptive recipe each batch is one run.
Batches render_round(const Recipe& recipe, const pt::View& view, const RowRenderer& rows,
                     const SeedSource& source, int round, int batches, int samples);

}  // namespace grader::pictures
