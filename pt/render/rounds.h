#pragma once

#include "pt/render/render_film.h"

#include <optional>

namespace pt {

// Samples per pixel of a round. It decides the bits of pictures with more samples.
inline constexpr int kRound = 64;

// Renders in rounds, so that a picture that is not complete can be shown, and gone on with: all
// pixels have kRound samples before any gets more. A picture of up to kRound samples is that of
// render_film. Adaptive pixels are complete in their first round.
//
// `start` is a picture that was stopped before, or empty. After each round its numbers are those of
// an EXR file, single precision, and the random numbers of a round depend on the seed and on the
// samples before it. So the bits are the same whether a picture is stopped, written, read and gone
// on with, or not.
//
// With `seconds`, no round begins that would not end in time, if it takes as long as the one before. The first
// round is always rendered. `complete` says whether all pixels have all samples.
RenderResult render_rounds(const View& view, const RenderSettings& settings, Film start,
                           std::optional<double> seconds,
                           const std::function<void(double)>& progress = {},
                           const std::atomic<bool>* stop = nullptr);

// The least and the most samples of a pixel.
struct SampleRange {
  int least = 0, most = 0;
};
SampleRange samples_of(const Film& film);

}  // namespace pt
