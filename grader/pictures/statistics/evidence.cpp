#include "grader/pictures/statistics/evidence.h"

#include "grader/pictures/statistics/guards.h"

#include <algorithm>

namespace grader::pictures {
namespace {

void lift(pt::Image& evidence, const Cell& cell, double value) {
  value = std::min(value, kMaxEvidence);
  for (int y = cell.y; y < cell.y + cell.height; ++y) {
    for (int x = cell.x; x < cell.x + cell.width; ++x) {
      if (evidence.at(x, y).r < value) evidence.at(x, y) = pt::gray(value);
    }
  }
}

double blend(double old, double now, double part) { return old + (now - old) * part; }

}  // namespace

void PooledFilm::add(const Moments& round) {
  const int samples = round.batches * round.samples;
  samples_ += samples;
  freedom_ += round.batches - 1;
  const double part = static_cast<double>(samples) / samples_;
  const double variance_part = static_cast<double>(round.batches - 1) / freedom_;
  for (std::size_t i = 0; i < film_.pixels.size(); ++i) {
    pt::FilmPixel& pixel = film_.pixels[i];
    pixel.samples = samples_;
    for (int c = 0; c < 3; ++c) {
      pixel.mean[c] = blend(pixel.mean[c], round.mean[c][i], part);
      pixel.variance[c] =
          blend(pixel.variance[c], round.variance[c][i] * round.samples, variance_part);
    }
    pixel.variance_y =
        blend(pixel.variance_y, round.variance[kLuminance][i] * round.samples, variance_part);
  }
}

pt::Image evidence_map(const Golden& golden, const Moments& round,
                       const std::vector<MeasuredCell>& measured,
                       const std::vector<MeasuredCell>& kept) {
  pt::Image evidence(golden.width, golden.height);
  for (const auto* cells : {&measured, &kept}) {
    for (const MeasuredCell& one : *cells) {
      // Constant pixels do not count in their blocks; they are set below.
      if (one.cell.scale != Scale::sum) lift(evidence, one.cell, one.evidence());
    }
  }
  for (std::size_t i = 0; i < golden.constant.size(); ++i) {
    if (!golden.constant[i]) continue;
    const double value = constant_error(golden, round, i).evidence;
    evidence.pixels[i] = pt::gray(std::min(value, kMaxEvidence));
  }
  return evidence;
}

}  // namespace grader::pictures
