#include "grader/pictures/statistics/cells.h"
#include "grader/pictures/statistics/guards.h"
#include "grader/pictures/statistics/image_verdict.h"
#include "pt/error.h"

#include <algorithm>

#include <fmt/format.h>

namespace grader::pictures {
namespace {

constexpr double kLevel = 5e-7;
constexpr std::size_t kMaxCells = 16;

// Both films as one: the means of the older film, and the variance of all samples together.
pt::Film pooled(const pt::Film& older, const pt::Film& newer) {
  pt::Film film = older;
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    const pt::FilmPixel& other = newer.pixels[i];
    pt::FilmPixel& pixel = film.pixels[i];
    const double part = static_cast<double>(other.samples) / (pixel.samples + other.samples);
    for (int c = 0; c < 3; ++c) {
      pixel.variance[c] += part * (other.variance[c] - pixel.variance[c]);
    }
    pixel.variance_y += part * (other.variance_y - pixel.variance_y);
  }
  return film;
}

}  // namespace

// Uses the larger of two variances: each film's own, and the variance of all their samples. The
// second prevents a difference where only the longer render has seen a rare light.
std::vector<results::FailingCell> contradictions(const pt::Film& older, const pt::Film& newer) {
  if (older.width != newer.width || older.height != newer.height) {
    throw pt::Error(
        fmt::format("the goldens are {} x {} and {} x {}: they are of different recipes",
                    older.width, older.height, newer.width, newer.height));
  }
  const Golden golden = prepare(pooled(older, newer));
  const Golden before = prepare(older), after = prepare(newer);
  Comparison pictures{golden, {}, {}, {}, {}};
  Moments round{1, 1, after.mean, {}};
  for (int plane = 0; plane < kPlanes; ++plane) {
    for (std::size_t i = 0; i < golden.samples.size(); ++i) {
      const double variance = golden.variance[plane][i];
      const double n = before.samples[i], m = after.samples[i];
      pictures.difference[plane].push_back(after.mean[plane][i] - before.mean[plane][i]);
      pictures.own[plane].push_back(before.variance[plane][i] / n + after.variance[plane][i] / m);
      pictures.expected[plane].push_back(variance / n + variance / m);
      pictures.golden_error[plane].push_back(0);
    }
  }
  const auto measured = measure(pictures, cells_of(golden), kLevel);
  std::vector<results::FailingCell> found;
  for (const MeasuredCell& one : smallest(exceeding(measured, measured.size()))) {
    found.push_back(failing_cell(one));
  }
  for (std::size_t i = 0; i < golden.constant.size(); ++i) {
    if (!golden.constant[i]) continue;
    const WrongConstant error = constant_error(golden, round, i);
    if (error.evidence <= 1) continue;
    const int x = static_cast<int>(i) % golden.width, y = static_cast<int>(i) / golden.width;
    found.push_back(failing_cell(
        {{Scale::pixel, error.plane, false, x, y, 1, 1}, error.evidence, 1, error.off_by}));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.evidence > b.evidence; });
  if (found.size() > kMaxCells) found.resize(kMaxCells);
  return found;
}

}  // namespace grader::pictures
