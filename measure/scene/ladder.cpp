#include "measure/scene/ladder.h"

#include "measure/scene/adaptive.h"
#include "measure/scene/ladder_turns.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

namespace measure::scene {

namespace {

using Direct = pt::PathSettings::Direct;

// Shares of the time. Programs must load the scene too.
constexpr double kOfLights = 0.05, kOfEngines = 0.15, kOfPictures = 0.35;

constexpr int kMaxAdaptive = 16;  // factor of the other rungs' samples

Chosen choose(Measuring& scene, int bounces) {
  const std::vector<pt::Light>& lights = scene.loaded.scene.lights;
  Chosen chosen;
  chosen.bounces = bounces;
  chosen.hemisphere = std::none_of(lights.begin(), lights.end(), pt::is_delta);
  chosen.rectangles = std::any_of(lights.begin(), lights.end(), [](const pt::Light& light) {
    return std::holds_alternative<pt::RectangleLight>(light);
  });
  double least = 0;
  for (const double survival : {1.0, 0.85, 0.7, 0.5, 0.3}) {
    if (bounces <= 2) break;  // there is no roulette
    const Way way{Direct::lights, bounces, survival};
    const double product = price(scene.study.try_out(way, {1})[0]).value;
    if (least > 0 && product >= least) continue;
    least = product;
    chosen.survival = survival;
  }
  if (!std::all_of(lights.begin(), lights.end(), pt::is_delta)) chosen.light_samples = 2;
  return chosen;
}

// Starts programs. Rungs that differ only in their settings share one program.
class Starter {
 public:
  Starter(int samples, std::vector<std::string> command)
      : samples_(samples), command_(std::move(command)) {}

  Worker start(const Rung& rung) {
    for (const Worker& other : started_) {
      if (other.rung.mixture == rung.mixture && other.rung.engine == rung.engine) {
        return {rung, other.program, other.spec};
      }
    }
    const auto program = std::make_shared<RungProgram>(command_, rung.mixture, rung.engine);
    started_.push_back(
        {rung, [program](const RungRequest& request) { return program->render(request); }, {}});
    started_.back().spec.samples = samples_;
    return started_.back();
  }

 private:
  int samples_;
  std::vector<std::string> command_;
  std::vector<Worker> started_;
};

// Chooses the ideas for light samples that pay here, and their numbers of samples, by the cost of
// each rung's own program. Solid angles are kept if they pay together with low-discrepancy samples, as one program
// has both.
void choose_lights(Chosen& chosen, Starter& starter, const Turning& turning) {
  Rung plain{"", "reference"};
  plain.way = {Direct::lights, chosen.bounces, chosen.survival};
  std::vector<LightTried> tried{{LightIdea::none, 1}};
  if (chosen.light_samples > 1) {
    for (const int l : {2, 4, 8}) tried.push_back({LightIdea::more_samples, l});
  }
  if (chosen.rectangles) {
    for (const int l : {2, 3, 4, 6}) tried.push_back({LightIdea::spread, l});
  }
  if (tried.size() == 1) return;
  std::vector<Worker> workers;
  for (const LightTried& each : tried) {
    chosen.spread_samples = chosen.light_samples = each.light_samples;
    workers.push_back(starter.start(with_lights(plain, each.idea, chosen)));
  }
  const std::vector<double> costs = costs_of(workers, turning);
  for (std::size_t i = 0; i < tried.size(); ++i) tried[i].cost = costs[i];
  chosen = with_cheapest_lights(chosen, tried);
}

// Adaptive sampling, as accurate as the same number of samples everywhere.
pt::AdaptiveSettings adaptive_like(Study& study, const Rung& rung, int samples) {
  pt::AdaptiveSettings settings{kMaxAdaptive * samples, std::clamp(samples / 8, 4, 32), 0.05};
  const std::vector<Study::PixelNoise> noise = study.pixel_noise(rung.way, rung.light_samples);
  double error2 = 0;
  for (const Study::PixelNoise& pixel : noise) error2 += pixel.relative / samples;
  settings.tolerance = tolerance_for(noise, settings, error2 / static_cast<double>(noise.size()));
  return settings;
}

constexpr double kAlways = 1;  // survival without roulette
constexpr const char* kUniform = "+diffuse_bsdf=uniform";

// The rungs for finding a ray's hit, with the simplest renderer. All show the same picture.
void add_engines(std::vector<Rung>& rungs, const Rung& plain) {
  const auto add = [&](const char* idea, const char* mixture, pt::Engine engine) {
    Rung rung = plain;
    rung.idea = idea;
    rung.mixture += mixture;
    rung.engine = engine;
    rung.same_picture = true;
    rungs.push_back(rung);
  };
  add("the plainest renderer", "", pt::Engine::linear);
  add("a tree, split at the midpoint", "+hit_bvh=recursive_unordered", pt::Engine::task);
  add("the nearer child first", "", pt::Engine::task);
  add("split by the surface area heuristic", "+build_bvh=swept_surface_area", pt::Engine::task);
  add("the wide engine", "", pt::Engine::wide);
  rungs.back().same_picture = false;
}

}  // namespace

Ladder climb(Measuring& scene, const Options& options, std::vector<std::string> command) {
  Ladder ladder;
  ladder.chosen = choose(scene, options.bounces);
  Chosen& chosen = ladder.chosen;
  Starter starter(options.samples, std::move(command));
  const double cpu = options.seconds * options.threads;
  const auto turning = [&](std::uint64_t series, double begin, double share) {
    return Turning{
        scene.study, options.seed + (series << 32), share * cpu,
        [&scene, begin, share](double part) { scene.progress.show(begin + share * part); }};
  };

  choose_lights(chosen, starter, turning(1, kOfChoices, kOfLights));
  const std::vector<Rung> rungs = rungs_of(chosen);
  std::vector<Worker> engines, pictures;
  for (const Rung& rung : rungs) {
    Worker worker = starter.start(rung);
    if (rung.adaptive) {
      worker.spec.adaptive = adaptive_like(scene.study, rung, options.samples);
      worker.spec.samples = worker.spec.adaptive->max_samples;
    }
    if (rung.same_picture)
      engines.push_back(worker);
    else
      pictures.push_back(worker);
  }
  engines.push_back(pictures[0]);
  std::vector<RungTurns> turns =
      time_engines(engines, turning(2, kOfChoices + kOfLights, kOfEngines));
  turns.pop_back();
  for (RungTurns& each :
       take_turns(pictures, turning(3, kOfChoices + kOfLights + kOfEngines, kOfPictures))) {
    turns.push_back(std::move(each));
  }
  ladder.rungs = worth_of(rungs, turns);
  return ladder;
}

Chosen with_cheapest_lights(Chosen chosen, const std::vector<LightTried>& tried) {
  const auto cheapest = [&](LightIdea idea) {
    const LightTried* best = nullptr;
    for (const LightTried& each : tried) {
      if (each.idea == idea && (best == nullptr || each.cost < best->cost)) best = &each;
    }
    return best;
  };
  const auto* const more = cheapest(LightIdea::more_samples);
  const auto* const spread = cheapest(LightIdea::spread);
  chosen.light_samples = more != nullptr ? more->light_samples : 1;
  chosen.more_pay = more != nullptr && more->cost < tried[0].cost;
  if (spread != nullptr) chosen.spread_samples = spread->light_samples;
  chosen.lights = std::ranges::min_element(tried, {}, &LightTried::cost)->idea;
  return chosen;
}

Rung with_lights(Rung rung, LightIdea idea, const Chosen& chosen) {
  const bool more = idea == LightIdea::more_samples || chosen.more_pay;
  rung.light_samples = idea != LightIdea::none && more ? chosen.light_samples : 1;
  switch (idea) {
    case LightIdea::none:
      break;
    case LightIdea::more_samples:
      rung.idea = fmt::format("{} light samples", chosen.light_samples);
      break;
    case LightIdea::solid_angle:
      rung.idea = "rectangles by solid angle";
      rung.mixture += "+direct_lights=solid_angle";
      break;
    case LightIdea::spread:
      rung.light_samples = chosen.spread_samples;
      rung.idea = fmt::format("{} low-discrepancy light samples", chosen.spread_samples);
      rung.mixture += "+direct_lights=solid_angle_low_discrepancy";
      break;
  }
  return rung;
}

std::vector<Rung> rungs_of(const Chosen& chosen) {
  Rung rung{"", "reference"};
  rung.way = {chosen.hemisphere ? Direct::hemisphere : Direct::lights, chosen.bounces, kAlways};
  std::vector<Rung> rungs;
  Rung plain = rung;
  plain.mixture += kUniform;
  add_engines(rungs, plain);

  const auto add = [&](const std::string& idea) {
    rung.idea = idea;
    rungs.push_back(rung);
  };
  add("cosine-weighted directions");
  if (chosen.hemisphere) {
    rung.way.direct = Direct::lights;
    add("light sampling");
  }
  if (chosen.survival < kAlways) {
    rung.way.survival = chosen.survival;
    add(fmt::format("roulette, survival {:g}", chosen.survival));
  }
  for (const LightIdea idea :
       {LightIdea::more_samples, LightIdea::solid_angle, LightIdea::spread}) {
    if (idea == LightIdea::more_samples ? chosen.light_samples == 1 : !chosen.rectangles) continue;
    rungs.push_back(with_lights(rung, idea, chosen));
    const bool pays = idea != LightIdea::more_samples || chosen.more_pay;
    rungs.back().kept = pays && idea <= chosen.lights;
  }
  rung = with_lights(rung, chosen.lights, chosen);
  const std::string lights = rung.mixture;
  rung.mixture = lights + "+estimate_pixel=stratified";
  add("stratified pixel");
  rung.mixture = lights + "+estimate_pixel=low_discrepancy+adaptive_pixel=low_discrepancy";
  add("low-discrepancy points of the pixel");
  rung.adaptive = true;
  add("adaptive sampling");
  return rungs;
}

}  // namespace measure::scene
