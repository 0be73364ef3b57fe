#pragma once

#include "grader/pictures/image_verdict.h"
#include "grader/pictures/recipes.h"
#include "grader/results/results.h"
#include "pt/image/sample_map.h"
#include "pt/render/render_rows.h"

#include <cstdint>
#include <functional>
#include <string>

// Pictures of a recipe, whoever renders their rows.

namespace grader::pictures {

// Renders the rows that are asked for: in a worker (worker_rows.h), or pt::render_rows with the
// tasks that this program links.
using RowRenderer = std::function<pt::PictureRows(const pt::View&, const pt::RowsRequest&)>;

// A worker made no picture. The text says what it did instead, for a person to read.
struct NoPicture {
  results::Cause cause = results::Cause::crash;
  std::string text;
};

// Chooses the random numbers of a picture: those of a submission's content, so that the same files
// get the same numbers and no others can be tried without changing them.
struct SeedSource {
  std::string content;     // a hash of what is judged
  std::uint64_t seed = 1;  // of the run
};

// The seed of one batch of a round; never a golden's (grader/pictures/seeds.h).
std::uint64_t batch_seed(const SeedSource& source, const Recipe& recipe, int round, int batch);

struct Rendered {
  pt::Image mean;        // as the task returned it, NaN included
  pt::SampleMap counts;  // of an adaptive recipe; else empty
};

Rendered render(const Recipe& recipe, const pt::View& view, const RowRenderer& rows, int samples,
                std::uint64_t seed);

// The batches of one round; of an adaptive recipe each is one run.
Batches render_round(const Recipe& recipe, const pt::View& view, const RowRenderer& rows,
                     const SeedSource& source, int round, int batches, int samples);

}  // namespace grader::pictures
