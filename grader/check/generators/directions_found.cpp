#include "grader/check/generators/directions_found.h"

#include "grader/check/language/fail.h"
#include "grader/check/scenes/closed_forms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace grader::check {

namespace {

constexpr std::array kRings{0.0, 20.0, 40.0, 60.0, 75.0, 90.0};  // degrees from the normal
constexpr int kSectors = 4;

double degrees(double radians) { return radians * 180 / pt::kPi; }

std::size_t ring_of(const DirectionCell& cell) {
  const double angle = degrees(std::acos(std::clamp(cell.middle.z, -1.0, 1.0)));
  const auto next = std::upper_bound(kRings.begin() + 1, kRings.end() - 1, angle);
  return static_cast<std::size_t>(next - kRings.begin()) - 1;
}

std::size_t sector_of(const DirectionCell& cell) {
  const double turn = std::atan2(cell.middle.y, cell.middle.x) / (2 * pt::kPi);
  return static_cast<std::size_t>((turn < 0 ? turn + 1 : turn) * kSectors) % kSectors;
}

struct Region {
  std::string name;
  double found = 0;
  double expected = 0;

  void add(const DirectionCell& cell) {
    found += cell.found;
    expected += cell.expected;
  }
  double strangeness() const {
    return expected > 0 || found > 0
               ? std::abs(found - expected) / std::sqrt(std::max(1.0, expected))
               : 0;
  }
};

// Returns the rings and the sectors around the normal, with their numbers of directions.
std::vector<Region> regions_of(const std::vector<DirectionCell>& cells) {
  std::vector<Region> regions;
  for (std::size_t i = 0; i + 1 < kRings.size(); ++i) {
    regions.push_back({i == 0 ? fmt::format("within {} degrees of the normal", kRings[1])
                              : fmt::format("between {} and {} degrees from the normal", kRings[i],
                                            kRings[i + 1])});
  }
  const std::size_t rings = regions.size();
  constexpr std::array kNames{"x > 0, y > 0", "x < 0, y > 0", "x < 0, y < 0", "x > 0, y < 0"};
  for (const char* name : kNames) regions.push_back({std::string("with local ") + name});
  for (const DirectionCell& cell : cells) {
    regions[ring_of(cell)].add(cell);
    regions[rings + sector_of(cell)].add(cell);
  }
  return regions;
}

}  // namespace

void expect_spread(const std::vector<DirectionCell>& cells, const std::string& source) {
  double chi_square = 0, all = 0, expected = 0;
  for (const DirectionCell& cell : cells) {
    const double off = cell.found - cell.expected;
    chi_square += off * off / std::max(cell.expected, 1.0);
    all += cell.found;
    expected += cell.expected;
  }
  if (chi_square < chi_square_limit(static_cast<int>(cells.size()))) return;
  const std::vector<Region> regions = regions_of(cells);
  const Region worst = *std::ranges::max_element(regions, {}, &Region::strangeness);
  const double by_chance = 6 * std::sqrt(std::max(1.0, worst.expected));
  if (!(std::abs(worst.found - worst.expected) > by_chance)) {
    fail_statistical(
        "how the directions are spread",
        fmt::format("a pattern: of {} cells of the hemisphere, some have too many directions, "
                    "others too few",
                    cells.size()),
        fmt::format("{:.0f} directions without a pattern{}", expected, source));
  }
  fail_statistical("where the directions are",
                   fmt::format("{:.0f} of {:.0f} directions {}", worst.found, all, worst.name),
                   fmt::format("{:.0f}, give or take {:.0f}{}", worst.expected, by_chance, source));
}

}  // namespace grader::check
