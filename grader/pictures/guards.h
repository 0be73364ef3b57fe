#pragma once

#include "grader/pictures/golden.h"
#include "grader/pictures/image_verdict.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// Faults of a picture that are not in its averages.

namespace grader::pictures {

struct Unusable {
  std::string sentence;
  std::optional<std::size_t> pixel;  // the faulty pixel, if it is one
};

// Returns why pictures cannot be judged: a value that cannot be a radiance, another size than the golden's, fewer
// images than `asked`, or two identical images whose samples should differ. Nothing if they can.
std::optional<Unusable> unusable(const Golden& golden, const Batches& batches, int asked);

// A pixel that is constant in the golden, as all its samples are equal, and has another value in the picture.
struct WrongConstant {
  std::size_t pixel = 0;
  int plane = 0;          // the channel that is furthest off
  double difference = 0;  // in that channel
  double off_by = 0;      // relative to the golden, as in MeasuredCell
  double evidence = 0;    // the difference over what is allowed
};

// The error of the constant pixel i, in units of what is allowed.
WrongConstant constant_error(const Golden& golden, const Moments& round, std::size_t i);

// The pixels that deviate on average, and in at least three of the batches: one that changes only
// once in as many samples as the golden has is constant by luck, and another picture may see it
// change.
std::vector<WrongConstant> wrong_constants(const Golden& golden, const Moments& round,
                                           const std::vector<pt::Image>& images);

// The noise of a picture as its batches show it, in luminance and without the constant pixels. All
// 0 where every pixel is constant.
struct Noise {
  double ratio = 0;        // variance of a sample over the golden's, mean over the pixels
  double correlation = 0;  // variance of the weighted sum over that of independent pixels
  double energy_off = 0;   // of the plain sum, relative
  double energy_t = 0;     // the same in standard deviations, as the batches have them
};

Noise measure_noise(const Golden& golden, const Moments& round,
                    const std::vector<pt::Image>& images);

}  // namespace grader::pictures
