#include "grader/pictures/statistics/sentences.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace grader::pictures {
namespace {

std::string too_much(double off_by) {
  const char* way = off_by > 0 ? "bright" : "dark";
  const double size = std::abs(off_by);
  if (size >= 10) return "more than 10 times as bright as it should be";
  return fmt::format("{:.{}f} % too {}", 100 * size,
                     size >= 0.0995    ? 0
                     : size >= 0.00095 ? 1
                                       : 2,
                     way);
}

std::string times(int renders) {
  if (renders < 2) return "";
  return renders == 2 ? " in two independent renders" : " in three independent renders";
}

std::string place(const Cell& cell) {
  if (cell.scale == Scale::sum) {
    return cell.weighted ? "the whole picture (noisy pixels count less)" : "the whole picture";
  }
  if (cell.scale == Scale::pixel) return fmt::format("this pixel ({}, {})", cell.x, cell.y);
  return fmt::format("this block ({}x{} at {}, {})", cell.width, cell.height, cell.x, cell.y);
}

std::string channel_of(int plane) {
  constexpr std::array<const char*, kPlanes> kColors{"the red of ", "the green of ", "the blue of ",
                                                     ""};
  return kColors[plane];
}

// The sum that the sentence is about, if the picture as a whole is off as much as its parts.
const MeasuredCell* off_everywhere(const std::vector<MeasuredCell>& all, const MeasuredCell& part) {
  const MeasuredCell* best = nullptr;
  for (const MeasuredCell& one : all) {
    const bool alike =
        one.off_by * part.off_by > 0 && std::abs(one.off_by) >= 0.5 * std::abs(part.off_by);
    const bool plane = one.cell.plane == kLuminance || one.cell.plane == part.cell.plane;
    if (one.cell.scale != Scale::sum || !alike || !plane) continue;
    if (!best || says_more(one, *best)) best = &one;
  }
  return best;
}

}  // namespace

std::string sentence(const std::vector<MeasuredCell>& all,
                     const std::vector<MeasuredCell>& smallest, int renders) {
  const MeasuredCell& part = smallest.front();
  const MeasuredCell* whole = off_everywhere(all, part);
  const MeasuredCell& what = whole ? *whole : part;
  return fmt::format("{}{} was {}{}", channel_of(what.cell.plane), place(what.cell),
                     too_much(what.off_by), times(renders));
}

std::string sentence(const std::vector<WrongConstant>& constants, const Golden& golden,
                     int renders) {
  const WrongConstant& worst =
      *std::max_element(constants.begin(), constants.end(),
                        [](const auto& a, const auto& b) { return a.evidence < b.evidence; });
  const int x = static_cast<int>(worst.pixel) % golden.width;
  const int y = static_cast<int>(worst.pixel) / golden.width;
  const double right = golden.mean[worst.plane][worst.pixel];
  const std::string where = fmt::format("{}pixel ({}, {})", channel_of(worst.plane), x, y);
  const std::string should =
      fmt::format("should always be {:.4g}, and was {:.4g}", right, right + worst.difference);
  if (constants.size() == 1) {
    return fmt::format("{}, in which nothing is random, {}{}", where, should, times(renders));
  }
  return fmt::format("{} pixels in which nothing is random were wrong{}: {} {}", constants.size(),
                     times(renders), where, should);
}

std::string correlated_sentence(int renders) {
  return "neighbouring pixels vary together" + times(renders) +
         ": they share random numbers, or a value is kept from one pixel to the next";
}

std::string too_near_sentence(int renders) {
  return "the picture was nearer to the golden than random samples can be" + times(renders) +
         ": it has to be made of samples, not of the golden";
}

std::string too_noisy_sentence(double ratio) {
  return fmt::format(
      "right on average, but too noisy: a sample has {:.1f} times the variance that "
      "it should have",
      ratio);
}

std::string noisy_and_wrong_sentence(double ratio, double energy_off, int renders) {
  return fmt::format(
      "the whole picture was {}{}, and a sample has {:.1f} times the variance that "
      "it should have",
      too_much(energy_off), times(renders), ratio);
}

}  // namespace grader::pictures
