#include "grader/pictures/recipes/render.h"

#include "grader/base/sha256.h"
#include "grader/pictures/recipes/seeds.h"

#include <fmt/format.h>

namespace grader::pictures {

namespace {

// Rows in one call: few enough for the time limit of a call on a slow machine, too.
constexpr int kRows = 8;

}  // namespace

std::uint64_t batch_seed(const SeedSource& source, const Recipe& recipe, int round, int batch) {
  const std::string hash = base::sha256(
      fmt::format("{} {} {} {} {}", source.content, source.seed, recipe.name, round, batch));
  return judged_seed(std::stoull(hash.substr(0, 16), nullptr, 16));
}

Rendered render(const Recipe& recipe, const pt::View& view, const RowRenderer& render_rows,
                int samples, std::uint64_t seed) {
  Rendered picture{pt::Image(view.width, view.height), {}};
  if (recipe.adaptive) {
    picture.counts = {view.width, view.height, {}, recipe.adaptive->max_samples};
    picture.counts.counts.resize(picture.mean.pixels.size());
  }
  for (int first = 0; first < view.height; first += kRows) {
    const int rows = std::min(kRows, view.height - first);
    const pt::PictureRows some = render_rows(view, {first, rows, samples, recipe.adaptive, seed});
    for (int i = 0; i < rows * view.width; ++i) {
      // Tasks count rows from the bottom, pictures from the top.
      const int y = view.height - 1 - (first + i / view.width);
      const std::size_t pixel = static_cast<std::size_t>(y) * view.width + i % view.width;
      picture.mean.pixels[pixel] = some.mean[i];
      if (recipe.adaptive) picture.counts.counts[pixel] = some.counts[i];
    }
  }
  return picture;
}

Batches render_round(const Recipe& recipe, const pt::View& view, const RowRenderer& rows,
                     const SeedSource& source, int round, int batches, int samples) {
  Batches all{samples, {}};
  for (int batch = 0; batch < batches; ++batch) {
    const std::uint64_t seed = batch_seed(source, recipe, round, batch);
    all.images.push_back(render(recipe, view, rows, samples, seed).mean);
  }
  return all;
}

}  // namespace grader::pictures
