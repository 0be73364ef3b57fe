#include "measure/scene/ladder_rungs.h"

#include <algorithm>

#include <fmt/format.h>

namespace measure::scene {

namespace {

using Direct = pt::PathSettings::Direct;

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
