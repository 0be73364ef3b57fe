#include "grader/pictures/goldens/check_golden.h"

#include "grader/pictures/goldens/contact_sheet.h"
#include "grader/pictures/goldens/make_golden.h"
#include "grader/pictures/goldens/provenance.h"
#include "grader/pictures/recipes/seeds.h"
#include "grader/pictures/statistics/sample_map_verdict.h"
#include "pt/error.h"
#include "pt/image/image_io.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace grader::pictures {

namespace {

constexpr double kMeanErrors = 5;
constexpr double kPixelErrors = 6.5;
constexpr double kRounding = 1e-6;  // relative, of single precision

using Sentences = std::vector<std::string>;

void check_film(const Recipe& recipe, const pt::Film& film, Sentences& found) {
  if (film.width != recipe.width || film.height != recipe.height) {
    found.push_back(fmt::format("its golden is {} x {} and not {} x {}", film.width, film.height,
                                recipe.width, recipe.height));
    return;
  }
  const Effort effort = usual_effort(recipe);
  const auto too_few = [&](const pt::FilmPixel& pixel) {
    return pixel.samples < effort.parts * effort.samples;
  };
  if (const auto pixel = std::find_if(film.pixels.begin(), film.pixels.end(), too_few);
      pixel != film.pixels.end()) {
    found.push_back(fmt::format("its golden has {} samples per pixel where {} are needed",
                                pixel->samples, effort.parts * effort.samples));
  }
  if (recipe.uniform) {
    for (const std::string& each : against_closed_form(film, *recipe.uniform)) {
      found.push_back(each);
    }
  }
}

void check_provenance(const Recipe& recipe, const Provenance& provenance, Sentences& found) {
  if (provenance.recipe != recipe.name) {
    found.push_back(fmt::format("its golden was made of the recipe '{}'", provenance.recipe));
  }
  if (provenance.sha256 != picture_hash(recipe)) {
    found.push_back("its recipe or its scene has changed since its golden was made");
  }
  if (provenance.first_seed != golden_seed(recipe, 0)) {
    found.push_back("its golden was made with another seed than the recipe's");
  }
}

void check_rates(const Recipe& recipe, const SampleMapReference& rates, Sentences& found) {
  const pt::AdaptiveSettings& wanted = *recipe.adaptive;
  if (rates.width != recipe.width || rates.height != recipe.height ||
      rates.settings.max_samples != wanted.max_samples || rates.settings.batch != wanted.batch ||
      rates.settings.tolerance != wanted.tolerance || rates.runs < usual_effort(recipe).parts) {
    found.push_back("its sample map has another size, other settings, or too few runs");
  }
}

}  // namespace

std::vector<std::string> against_closed_form(const pt::Film& film, pt::Rgb radiance) {
  Sentences found;
  const auto count = static_cast<double>(film.pixels.size());
  for (int channel = 0; channel < 3; ++channel) {
    const double truth = radiance[channel];
    double off = 0, variance = 0, worst = 0;
    for (const pt::FilmPixel& pixel : film.pixels) {
      const double difference = pixel.mean[channel] - truth;
      const double of_mean = pixel.variance[channel] / pixel.samples;
      off += difference;
      variance += of_mean;
      const double rounding = kRounding * truth;
      worst = std::max(worst, std::abs(difference) / std::sqrt(of_mean + rounding * rounding));
    }
    const double rounding = kRounding * truth * count;
    const double errors = off / std::sqrt(variance + rounding * rounding);
    if (!(std::abs(errors) <= kMeanErrors)) {
      found.push_back(fmt::format(
          "every pixel's {} should be {:.6g}, but their mean is {:.6g}, {:.1f} standard errors off",
          "rgb"[channel], truth, truth + off / count, errors));
    }
    if (!(worst <= kPixelErrors)) {
      found.push_back(
          fmt::format("every pixel's {} should be {:.6g}, but one is {:.1f} standard errors off",
                      "rgb"[channel], truth, worst));
    }
  }
  return found;
}

std::vector<std::string> check_golden(const Recipe& recipe, const std::filesystem::path& folder) {
  Sentences found;
  const GoldenFiles files = golden_files(folder, recipe.name);
  try {
    check_provenance(recipe, read_provenance(files.provenance), found);
    expect_as_made(files);
    check_film(recipe, pt::read_exr(files.film), found);
    if (recipe.adaptive) check_rates(recipe, read_reference(files.rates), found);
  } catch (const pt::Error& error) {
    found.emplace_back(error.what());
  }
  for (std::string& each : found) {
    each = fmt::format("recipe '{}': {}; run ./run bless {}", recipe.name, each, recipe.name);
  }
  return found;
}

std::vector<std::string> check_goldens(const std::vector<Recipe>& recipes,
                                       const std::filesystem::path& folder) {
  Sentences found;
  std::set<std::filesystem::path> known{folder / kSheetName};
  for (const Recipe& recipe : recipes) {
    for (const std::string& each : check_golden(recipe, folder)) found.push_back(each);
    const GoldenFiles files = golden_files(folder, recipe.name);
    known.insert({files.film, files.provenance});
    if (recipe.adaptive) known.insert(files.rates);
  }
  if (!std::filesystem::is_directory(folder)) return found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!known.contains(entry.path())) {
      found.push_back(fmt::format("'{}' belongs to no recipe; remove it", entry.path().string()));
    }
  }
  return found;
}

}  // namespace grader::pictures
