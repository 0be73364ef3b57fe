#pragma once

#include "grader/pictures/goldens/golden.h"
#include "grader/pictures/statistics/image_verdict.h"

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

// Returns the reason why pictures cannot be judged: a value that cannot be a radiance, another size than the golden's,
// fewer images than `asked`, or two identical images whose samples should differ. Returns nothing if they can.
std::optional<Unusable> unusable(const Golden& golden, const Batches& batches, int asked);

// A pixel that is constant in the golden (all its samples are equal) and has another value in the picture.
struct WrongConstant {
  std::size_t pixel = 0;
  int plane = 0;          // the channel that is furthest off
  double difference = 0;  // in that channel
  double off_by = 0;      // relative to the golden, as in MeasuredCell
  double evidence = 0;    // the difference over the allowed difference
};

// The error of the constant pixel i, in units of the allowed error.
WrongConstant constant_error(const Golden& golden, const Moments& round, std::size_t i);

// The pixels that deviate on average, and in at least three of the batches. A pixel that changes
// only once in as many samples as the golden has is constant in the golden by luck.
std::vector<WrongConstant> wrong_constants(const Golden& golden, const Moments& round,
                                           const std::vector<pt::Image>& images);

// Returns whether the picture is nearer to the golden than independent samples can be, however good: the
// golden is not that near to the truth.
bool is_too_near(const Comparison& pictures);

// The noise of a picture as its batches show it, in luminance and without the constant pixels. All
// 0 if every pixel is constant.
struct Noise {
  double ratio = 0;        // variance of a sample over the golden's, mean over the pixels
  double correlation = 0;  // variance of the weighted sum over that of independent pixels
  double energy_off = 0;   // relative error of the plain sum
  double energy_t = 0;     // the same in standard deviations, as the batches have them
};

Noise measure_noise(const Golden& golden, const Moments& round,
                    const std::vector<pt::Image>& images);

}  // namespace grader::pictures
