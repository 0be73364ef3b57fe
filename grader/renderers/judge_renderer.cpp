#include "grader/renderers/judge_renderer.h"

#include "grader/base/sha256.h"
#include "grader/pictures/goldens/make_golden.h"
#include "grader/pictures/goldens/provenance.h"
#include "grader/pictures/statistics/guards.h"
#include "grader/pictures/statistics/image_verdict.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::renderers {

using namespace pictures;

namespace {

constexpr int kProbe = 6;               // pictures that only show how much noise there is
constexpr double kNoiseLikeOurs = 1.5;  // half of what a picture of the usual class may have

// A cell of the first round that is so many times beyond its threshold needs no second round: more than 16 standard deviations.
constexpr double kObvious = 4;

std::uint32_t seed_of(const OtherRenderer& renderer, const Recipe& recipe, int round, int batch) {
  const std::string hash =
      base::sha256(fmt::format("{} {} {} {} {}", fmt::join(renderer.command, " "), recipe.name,
                               picture_hash(recipe), round, batch));
  return static_cast<std::uint32_t>(std::stoull(hash.substr(0, 8), nullptr, 16) >> 1);
}

// Renders batches, each with `times` as many samples as it counts for.
class Rounds {
 public:
  Rounds(const Recipe& recipe, const OtherRenderer& renderer, const std::filesystem::path& scene)
      : recipe_(recipe), renderer_(renderer), scene_(scene) {}

  Batches render_round(int round, int batches, int samples) const {
    Batches all{samples, {}};
    for (int i = 0; i < batches; ++i) {
      all.images.push_back(render(
          renderer_,
          {scene_.string(), recipe_.width, recipe_.height, samples * times_, recipe_.settings.to,
           recipe_.settings.from, recipe_.settings.to, seed_of(renderer_, recipe_, round, i)}));
    }
    return all;
  }

  // Asks for as many more samples as the noise of a few pictures needs.
  void fit(const pt::Film& film, int samples) {
    const Golden golden = prepare(film);
    const Batches few = render_round(0, kProbe, samples);
    if (unusable(golden, few, kProbe)) return;  // the first round says why
    const double ratio = measure_noise(golden, moments(few.images, few.samples), few.images).ratio;
    if (!(ratio > 2 * kNoiseLikeOurs)) return;
    times_ =
        static_cast<int>(std::min<double>(std::ceil(ratio / kNoiseLikeOurs), kMostTimesTheSamples));
  }

  int times() const { return times_; }

 private:
  const Recipe& recipe_;
  const OtherRenderer& renderer_;
  std::filesystem::path scene_;
  int times_ = 1;
};

bool is_obvious(const ImageVerdict& verdict) {
  return verdict.outcome == ImageVerdict::Outcome::wrong && !verdict.cells.empty() &&
         verdict.cells[0].evidence > kObvious;
}

}  // namespace

NoiseClass noise_class_of(const pt::Film& golden) {
  double sum = 0;
  int lit = 0;
  for (const pt::FilmPixel& pixel : golden.pixels) {
    const double y = luminance(pixel.mean);
    if (!(y > 0) || pixel.variance_y == 0) continue;
    sum += pixel.variance_y / (y * y);
    ++lit;
  }
  return lit > 0 && sum / lit > kNoisyVariance ? NoiseClass::noisy : NoiseClass::ordinary;
}

pt::Film golden_of(const Recipe& recipe, const std::filesystem::path& folder, int threads,
                   const std::function<void(double)>& progress) {
  std::filesystem::create_directories(folder);
  const std::string name = base::sha256(picture_hash(recipe)).substr(0, 24);
  const GoldenState state =
      render_golden(recipe, usual_effort(recipe), threads, folder / (name + ".cbor"), progress);
  return film_of(recipe, state);
}

results::PictureResult judge_renderer(const Recipe& recipe, const pt::Film& golden,
                                      const OtherRenderer& renderer,
                                      const std::filesystem::path& scene,
                                      const PictureFiles& files) {
  const auto start = std::chrono::steady_clock::now();
  Rounds rounds(recipe, renderer, scene);
  results::PictureResult result = [&] {
    try {
      const NoiseClass noise = noise_class_of(golden);
      const Round first = rounds_of(noise)[0];
      rounds.fit(golden, first.samples);
      const Batches begun = rounds.render_round(1, first.batches, first.samples);
      const auto render_round = [&](int round, int batches, int samples) {
        return round == 1 ? begun : rounds.render_round(round, batches, samples);
      };
      const ImageVerdict at_once = judge_image(golden, noise, render_round, 1);
      return described(recipe, files,
                       is_obvious(at_once) ? at_once : judge_image(golden, noise, render_round));
    } catch (const NoPicture& none) {
      return described(recipe, files, none);
    }
  }();
  result.samples *= rounds.times();
  result.noise *= rounds.times();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace grader::renderers
