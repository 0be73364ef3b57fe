#pragma once

#include "measure/calls/exact.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/scene.h"

namespace measure::calls {

inline constexpr int kPlaces = 64;
inline constexpr int kDraws = 16;  // draws per place, for its variance

// One estimate, and its number of samples.
struct Estimate {
  double value = 0;
  double samples = 0;
};

// An estimator: draw(place, sampler) returns an Estimate, whose true mean is place.truth.
template <class Place, class Draw>
Subject estimator_subject(std::vector<Place> all, Draw draw) {
  const auto places = std::make_shared<const std::vector<Place>>(std::move(all));
  const auto sampler = std::make_shared<pt::Sampler>(1);
  const auto pass = [places, sampler, draw] {
    double sum = 0;
    for (const Place& place : *places) sum += draw(place, *sampler).value;
    sink = sum;
  };
  const auto find = [places, draw](std::uint64_t seed) {
    Found found;
    pt::Sampler stream(seed);
    const pt::RayCount before = pt::rays_traced();
    double truth = 0, truth2 = 0;
    for (const Place& place : *places) {
      double sum = 0, sum2 = 0;
      for (int i = 0; i < kDraws; ++i) {
        const Estimate estimate = draw(place, stream);
        const double off = estimate.value - place.truth;
        sum += off;
        sum2 += off * off;
        found.samples += estimate.samples;
      }
      found.mean += sum / kDraws;
      found.variance += (sum2 - sum * sum / kDraws) / (kDraws - 1);
      truth += place.truth;
      truth2 += place.truth * place.truth;
    }
    const pt::RayCount after = pt::rays_traced();
    const double calls = kDraws * static_cast<double>(places->size());
    found.mean = 1 + found.mean / truth;
    found.variance /= truth2;
    found.samples /= calls;
    found.rays =
        static_cast<double>(after.closest - before.closest + after.occluded - before.occluded) /
        calls;
    return found;
  };
  return {static_cast<int>(places->size()), pass, find};
}

}  // namespace measure::calls
