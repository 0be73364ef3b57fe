#include "grader/pictures/goldens/contact_sheet.h"

#include "grader/pictures/goldens/make_golden.h"
#include "grader/pictures/goldens/provenance.h"
#include "grader/pictures/statistics/image_verdict.h"
#include "pt/image/image_io.h"
#include "pt/image/tone_map.h"
#include "pt/math/uncertain.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::pictures {

namespace {

constexpr int kColumns = 6;
constexpr int kGap = 6;
constexpr int kTextHeight = 12;
constexpr pt::Color8 kGround{40, 40, 40}, kText{230, 230, 230};

// The noise of a picture, per sample and relative to the radiance.
struct Noise {
  double middle = 0;  // the median of the pixels that are neither black nor constant
  double mean = 0;    // the root of the mean variance over the mean radiance
};

Noise noise_of(const pt::Film& film) {
  std::vector<double> relative;
  double variance = 0, radiance = 0;
  for (const pt::FilmPixel& pixel : film.pixels) {
    variance += pixel.variance_y;
    radiance += luminance(pixel.mean);
    if (pixel.variance_y > 0) {
      relative.push_back(std::sqrt(pixel.variance_y) / luminance(pixel.mean));
    }
  }
  if (relative.empty()) return {};
  return {pt::median_of(relative), std::sqrt(variance / static_cast<double>(film.pixels.size())) *
                                       static_cast<double>(film.pixels.size()) / radiance};
}

void place(pt::Picture& onto, const pt::Picture& picture, int left, int top) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) onto.at(left + x, top + y) = picture.at(x, y);
  }
}

}  // namespace

pt::Picture contact_sheet(const std::vector<Recipe>& recipes, const std::filesystem::path& folder) {
  int width = 0, height = 0;
  for (const Recipe& recipe : recipes) {
    width = std::max({width, recipe.width, pt::text_width(1, recipe.name)});
    height = std::max(height, recipe.height);
  }
  const int rows = (static_cast<int>(recipes.size()) + kColumns - 1) / kColumns;
  const int step_x = width + kGap, step_y = height + kTextHeight + kGap;
  pt::Picture sheet(kColumns * step_x + kGap, rows * step_y + kGap, kGround);
  int place_number = 0;
  for (const Recipe& recipe : recipes) {
    const int left = kGap + place_number % kColumns * step_x;
    const int top = kGap + place_number / kColumns * step_y;
    ++place_number;
    const std::filesystem::path film = golden_files(folder, recipe.name).film;
    if (std::filesystem::exists(film)) {
      const pt::Picture picture = pt::tone_map(mean(pt::read_exr(film)), 1);
      place(sheet, picture, left, top + height - picture.height);
    }
    pt::draw_text(sheet, left, top + height + 3, 1, recipe.name, kText);
  }
  return sheet;
}

std::string golden_table(const std::vector<Recipe>& recipes, const std::filesystem::path& folder) {
  std::string table =
      "| recipe | what it shows | judges | noise | seconds |\n|---|---|---|---|---|\n";
  for (const Recipe& recipe : recipes) {
    const GoldenFiles files = golden_files(folder, recipe.name);
    const Noise noise = noise_of(pt::read_exr(files.film));
    const Provenance provenance = read_provenance(files.provenance);
    const Round first = recipe.adaptive
                            ? kAdaptiveRounds[0]
                            : rounds_of(recipe.noisy ? NoiseClass::noisy : NoiseClass::ordinary)[0];
    table += fmt::format(
        "| {}{} | {} | {} | {:.2f}, {:.2f} | {:.2f} |\n", recipe.name,
        recipe.noisy ? " (noisy)" : "", recipe.title, fmt::join(recipe.tasks, ", "), noise.middle,
        noise.mean, provenance.cpu_seconds * first.batches * first.samples / provenance.samples);
  }
  return table;
}

}  // namespace grader::pictures
