#include "grader/images/name_mistake.h"

#include "grader/images/cells.h"
#include "grader/images/guards.h"

#include <algorithm>
#include <limits>

namespace grader {
namespace {

constexpr double kLevel = 1e-2;

// The mean square of the deviations, each in units of its own standard deviation. Constant pixels
// count by what is allowed there.
double distance(const Comparison& pictures, const Moments& stage) {
  const Golden& picture = pictures.golden;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < picture.samples.size(); ++i) {
    if (picture.constant[i]) {
      const double evidence = constant_error(picture, stage, i).evidence;
      sum += evidence * evidence;
      ++count;
      continue;
    }
    for (int plane = 0; plane < kLuminance; ++plane) {
      const double variance = std::max(pictures.own[plane][i], pictures.expected[plane][i]) +
                              pictures.golden_error[plane][i];
      const double difference = pictures.difference[plane][i];
      if (variance > 0) sum += difference * difference / variance;
      ++count;
    }
  }
  return sum / count;
}

bool agrees(const Golden& picture, const Comparison& pictures, const Moments& stage,
            const Batches& batches) {
  return exceeding(measure(pictures, cells_of(picture), kLevel), 1).empty() &&
         wrong_constants(picture, stage, batches.images).empty();
}

}  // namespace

std::optional<std::string> name_mistake(const pt::Film& golden, const Batches& batches,
                                        std::span<const KnownMistake> mistakes) {
  const Moments stage = moments(batches.images, batches.samples);
  const Golden right = prepare(golden);
  if (agrees(right, compare(right, stage), stage, batches)) return {};
  std::optional<std::string> name;
  double nearest = std::numeric_limits<double>::infinity();
  for (const KnownMistake& mistake : mistakes) {
    const Golden picture = prepare(mistake.picture);
    const Comparison pictures = compare(picture, stage);
    const double far = distance(pictures, stage);
    if (far >= nearest) continue;
    nearest = far;
    name.reset();
    if (agrees(picture, pictures, stage, batches)) name = mistake.name;
  }
  return name;
}

}  // namespace grader
