#include "grader/pictures/statistics/cells.h"

#include "grader/base/normal.h"
#include "grader/pictures/statistics/blocks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace grader::pictures {
namespace {

constexpr double kLargestZ = 1e6;
constexpr double kAbsoluteMargin = 5e-4;
// Relative margins, by scale.
constexpr std::array<double, kScales> kMargins{0.02, 0.01, 0.0075, 0.005, 0.003};

int index(Scale scale) { return static_cast<int>(scale); }

const Plane& weights(const Golden& golden, const Cell& cell) {
  return cell.weighted ? golden.weighted : golden.plain;
}

bool holds_weight(const Golden& golden, const Cell& cell) {
  const Plane& weight = weights(golden, cell);
  for (int y = cell.y; y < cell.y + cell.height; ++y) {
    const auto row = weight.begin() + static_cast<std::ptrdiff_t>(y) * golden.width + cell.x;
    if (std::any_of(row, row + cell.width, [](double w) { return w > 0; })) return true;
  }
  return false;
}

void add_blocks(std::vector<Cell>& cells, const Golden& golden, Scale scale, int side, int plane) {
  for_each_block(golden.width, golden.height, side, [&](int x, int y, int width, int height) {
    const Cell cell{scale, plane, false, x, y, width, height};
    if (holds_weight(golden, cell)) cells.push_back(cell);
  });
}

MeasuredCell measure(const Comparison& pictures, const Cell& cell) {
  const Golden& golden = pictures.golden;
  const Plane& weight = weights(golden, cell);
  double sum = 0, difference = 0, mean = 0, own = 0, expected = 0, golden_error = 0;
  for (int y = cell.y; y < cell.y + cell.height; ++y) {
    for (int x = cell.x; x < cell.x + cell.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * golden.width + x;
      const double w = weight[i];
      sum += w;
      difference += w * pictures.difference[cell.plane][i];
      mean += w * golden.mean[cell.plane][i];
      own += w * w * pictures.own[cell.plane][i];
      expected += w * w * pictures.expected[cell.plane][i];
      golden_error += w * w * pictures.golden_error[cell.plane][i];
    }
  }
  difference /= sum;
  mean /= sum;
  // With too few bright hits a picture's own variance is too small, beside a firefly the golden's
  // is: the larger of the two is safe in both cases.
  const double deviation = std::sqrt(std::max(own, expected) + golden_error) / sum;
  const double scale = golden.scale[cell.plane];
  const double margin = kMargins[index(cell.scale)] * mean + kAbsoluteMargin * scale;
  const double excess = std::max(0.0, std::abs(difference) - margin);
  const double z = excess > 0 ? std::min(kLargestZ, excess / deviation) : 0;
  return {cell, std::copysign(z, difference), 0, difference / std::max(mean, 1e-3 * scale)};
}

bool clearer(const MeasuredCell& a, const MeasuredCell& b) { return a.evidence() > b.evidence(); }

bool same_place(const Cell& a, const Cell& b) {
  return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

bool holds(const Cell& outer, const Cell& inner) {
  return !same_place(outer, inner) && inner.x >= outer.x && inner.y >= outer.y &&
         inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

}  // namespace

double MeasuredCell::evidence() const { return std::abs(z) / threshold; }

bool says_more(const MeasuredCell& a, const MeasuredCell& b) {
  const auto weight = [](const MeasuredCell& one) {
    const double plane = one.cell.plane == kLuminance ? 2.5 : 1;
    return std::abs(one.off_by) * plane * (one.cell.weighted ? 0.9 : 1);
  };
  return weight(a) > weight(b);
}

std::vector<Cell> cells_of(const Golden& golden) {
  std::vector<Cell> cells;
  add_blocks(cells, golden, Scale::pixel, 1, kLuminance);
  add_blocks(cells, golden, Scale::block4, 4, kLuminance);
  add_blocks(cells, golden, Scale::block8, 8, kLuminance);
  for (int plane = 0; plane < kPlanes; ++plane) {
    add_blocks(cells, golden, Scale::block24, 24, plane);
    for (const bool weighted : {false, true}) {
      const Cell all{Scale::sum, plane, weighted, 0, 0, golden.width, golden.height};
      if (holds_weight(golden, all)) cells.push_back(all);
    }
  }
  return cells;
}

std::vector<MeasuredCell> measure(const Comparison& pictures, const std::vector<Cell>& cells,
                                  double level) {
  std::array<int, kScales> counts{};
  for (const Cell& cell : cells) ++counts[index(cell.scale)];
  std::array<double, kScales> thresholds{};
  for (int scale = 0; scale < kScales; ++scale) {
    if (counts[scale] > 0) {
      thresholds[scale] = base::normal_quantile_above(level / kScales / counts[scale] / 2);
    }
  }
  std::vector<MeasuredCell> measured;
  measured.reserve(cells.size());
  for (const Cell& cell : cells) {
    measured.push_back(measure(pictures, cell));
    measured.back().threshold = thresholds[index(cell.scale)];
  }
  return measured;
}

std::vector<MeasuredCell> exceeding(const std::vector<MeasuredCell>& measured, std::size_t most) {
  std::vector<MeasuredCell> found;
  for (const MeasuredCell& one : measured) {
    if (!(std::abs(one.z) <= one.threshold)) found.push_back(one);
  }
  std::stable_sort(found.begin(), found.end(), clearer);
  if (found.size() > most) found.resize(most);
  return found;
}

std::vector<MeasuredCell> repeated(const Comparison& pictures,
                                   const std::vector<MeasuredCell>& kept, double level) {
  std::vector<MeasuredCell> found;
  for (const MeasuredCell& before : kept) {
    MeasuredCell now = measure(pictures, before.cell);
    now.threshold = base::normal_quantile_above(level / static_cast<double>(kept.size()));
    const bool same_sign = std::signbit(now.z) == std::signbit(before.z);
    if (same_sign && !(std::abs(now.z) <= now.threshold)) found.push_back(now);
  }
  std::stable_sort(found.begin(), found.end(), clearer);
  return found;
}

std::vector<MeasuredCell> smallest(std::vector<MeasuredCell> cells) {
  std::stable_sort(cells.begin(), cells.end(), says_more);
  std::vector<MeasuredCell> found;
  for (const MeasuredCell& one : cells) {
    const bool larger = std::any_of(cells.begin(), cells.end(),
                                    [&](const MeasuredCell& o) { return holds(one.cell, o.cell); });
    const bool known = std::any_of(found.begin(), found.end(), [&](const MeasuredCell& o) {
      return same_place(one.cell, o.cell);
    });
    if (!larger && !known) found.push_back(one);
  }
  std::stable_sort(found.begin(), found.end(), clearer);
  return found;
}

results::FailingCell failing_cell(const MeasuredCell& measured) {
  constexpr std::array<const char*, kPlanes> kNames{"R", "G", "B", "Y"};
  const Cell& cell = measured.cell;
  return {cell.x,
          cell.y,
          cell.width,
          cell.height,
          kNames[cell.plane],
          measured.off_by,
          measured.evidence()};
}

}  // namespace grader::pictures
