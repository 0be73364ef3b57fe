#include "grader/pictures/recipes/judge_recipe.h"

#include "grader/base/sha256.h"
#include "grader/pictures/goldens/golden.h"
#include "grader/pictures/recipes/seeds.h"
#include "grader/pictures/statistics/image_verdict.h"
#include "grader/pictures/statistics/sample_map_verdict.h"
#include "pt/error.h"
#include "pt/image/image_io.h"
#include "pt/image/sample_map.h"

#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace grader::pictures {

namespace {

// Rows in one call: few enough for the time limit of a call on a slow machine, too.
constexpr int kRows = 8;

// The seed of one batch of a round; never a golden's (grader/pictures/recipes/seeds.h).
std::uint64_t batch_seed(const SeedSource& source, const Recipe& recipe, int round, int batch) {
  const std::string hash = base::sha256(
      fmt::format("{} {} {} {} {}", source.content, source.seed, recipe.name, round, batch));
  return judged_seed(std::stoull(hash.substr(0, 16), nullptr, 16));
}

struct Rendered {
  pt::Image mean;        // as the task returned it, NaN included
  pt::SampleMap counts;  // of an adaptive recipe; else empty
};

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

// Renders the batches of one round, but for the first ones, which are there already. For an adaptive
// recipe each batch is one run.
Batches render_round(const Recipe& recipe, const pt::View& view, const RowRenderer& rows,
                     const SeedSource& source, int round, int batches, int samples,
                     std::vector<pt::Image> first = {}) {
  Batches all{samples, std::move(first)};
  for (int batch = static_cast<int>(all.images.size()); batch < batches; ++batch) {
    const std::uint64_t seed = batch_seed(source, recipe, round, batch);
    all.images.push_back(render(recipe, view, rows, samples, seed).mean);
  }
  return all;
}

results::State state_of(ImageVerdict::Outcome outcome) {
  switch (outcome) {
    case ImageVerdict::Outcome::pass:
      return results::State::pass;
    case ImageVerdict::Outcome::too_noisy:
      return results::State::too_noisy;
    case ImageVerdict::Outcome::wrong:
    case ImageVerdict::Outcome::unusable:
      break;
  }
  return results::State::fail;
}

results::State state_of(results::Cause cause) {
  switch (cause) {
    case results::Cause::crash:
      return results::State::crash;
    case results::Cause::timeout:
      return results::State::timeout;
    case results::Cause::not_attempted:
      return results::State::not_attempted;
    case results::Cause::wrong:
    case results::Cause::bad_reply:
    case results::Cause::not_called:
      break;
  }
  return results::State::fail;
}

// The result before anything is judged.
results::PictureResult unjudged(const Recipe& recipe, const PictureFiles& files) {
  results::PictureResult result;
  result.recipe = recipe.name;
  result.title = recipe.title;
  result.width = recipe.width;
  result.height = recipe.height;
  result.golden = files.golden;
  return result;
}

// A film of one value per pixel, as an EXR holds it.
pt::Film film_of(const pt::Image& image) {
  pt::Film film(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) film.pixels[i].mean = image.pixels[i];
  return film;
}

}  // namespace

results::PictureResult described(const Recipe& recipe, const PictureFiles& files,
                                 const ImageVerdict& verdict) {
  results::PictureResult result = unjudged(recipe, files);
  result.state = state_of(verdict.outcome);
  result.text = verdict.sentence;
  result.samples = verdict.samples;
  result.rounds = verdict.rounds;
  result.noise = verdict.noise;
  result.cells = verdict.cells;
  if (verdict.render.width == 0 || files.render.empty()) return result;
  pt::write_image(files.render, verdict.render);
  pt::write_image(files.evidence, film_of(verdict.evidence));
  result.render = files.render;
  result.evidence = files.evidence;
  return result;
}

results::PictureResult described(const Recipe& recipe, const PictureFiles& files,
                                 const NoPicture& none) {
  results::PictureResult result = unjudged(recipe, files);
  result.state = state_of(none.cause);
  result.text = none.text;
  return result;
}

namespace {

// Blackens each pixel whose first batch may be all zero: a right program may stop there or go on,
// so such pixels are not judged.
void blacken(const std::vector<char>& where, pt::Image& image) {
  for (std::size_t i = 0; i < where.size(); ++i) {
    if (where[i] != 0) image.pixels[i] = {};
  }
}

void blacken(const std::vector<char>& where, pt::Film& film) {
  for (std::size_t i = 0; i < where.size(); ++i) {
    if (where[i] != 0) film.pixels[i] = {{}, {}, 0, film.pixels[i].samples};
  }
}

// Judges the sample map of one run, then the picture, in which a run counts as a sample. That run is
// the first of the picture's first round.
results::PictureResult judge_adaptive(const Recipe& recipe, const pt::View& view,
                                      const Rendering& rendering, const PictureFiles& files) {
  const SampleMapReference reference = read_reference(files.rates);
  const Rendered run =
      render(recipe, view, rendering.rows, 1, batch_seed(rendering.source, recipe, 1, 0));
  const SampleMapVerdict map = judge_sample_map(reference, run.counts);
  const pt::Film whole = read_golden(files.golden, recipe);
  pt::Film golden = whole;
  blacken(reference.dark_start, golden);
  ImageVerdict verdict = judge_image(
      golden, NoiseClass::ordinary,
      [&](int round, int batches, int samples) {
        std::vector<pt::Image> first;
        if (round == 1) first.push_back(run.mean);
        Batches all = render_round(recipe, view, rendering.rows, rendering.source, round, batches,
                                   samples, std::move(first));
        for (pt::Image& image : all.images) blacken(reference.dark_start, image);
        return all;
      },
      rendering.max_rounds, kAdaptiveRounds);
  for (std::size_t i = 0; i < verdict.render.pixels.size(); ++i) {
    if (reference.dark_start[i] != 0) verdict.render.pixels[i] = whole.pixels[i];
  }
  results::PictureResult result = described(recipe, files, verdict);
  if (!files.counts.empty()) {
    pt::write_counts(files.counts, run.counts);
    pt::write_counts(files.golden_counts, usual_counts(reference));
    result.golden_counts = files.golden_counts;
    result.counts = files.counts;
  }
  if (!map.pass) {
    result.state = results::State::fail;
    result.text = map.sentence;
  }
  return result;
}

results::PictureResult judge(const Recipe& recipe, const pt::View& view, const Rendering& rendering,
                             const PictureFiles& files) {
  if (recipe.adaptive) return judge_adaptive(recipe, view, rendering, files);
  const ImageVerdict verdict = judge_image(
      read_golden(files.golden, recipe), recipe.noisy ? NoiseClass::noisy : NoiseClass::ordinary,
      [&](int round, int batches, int samples) {
        return render_round(recipe, view, rendering.rows, rendering.source, round, batches,
                            samples);
      },
      rendering.max_rounds, recipe.most_noise);
  return described(recipe, files, verdict);
}

}  // namespace

results::PictureResult judge_recipe(const Recipe& recipe, const Rendering& rendering,
                                    const PictureFiles& files) {
  const auto start = std::chrono::steady_clock::now();
  const RecipeScene scene = load_scene(recipe, rendering.engine);
  results::PictureResult result = [&] {
    try {
      return judge(recipe, view(recipe, scene), rendering, files);
    } catch (const NoPicture& none) {
      return described(recipe, files, none);
    }
  }();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace grader::pictures
