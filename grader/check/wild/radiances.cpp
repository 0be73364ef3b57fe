#include "grader/check/wild/radiances.h"

#include "grader/check/language/show.h"
#include "grader/check/wild/wild_scene.h"

#include <cmath>

#include <fmt/format.h>

namespace grader::check {

namespace {

pt::Rgb radiance_of(const WildRadiances& of, double chance, double other) {
  switch (of.kind) {
    case WildRadiances::Kind::constant:
      return of.base;
    case WildRadiances::Kind::uniform:
      return of.base * chance;
    case WildRadiances::Kind::two_values:
      return chance < of.share ? of.base * of.bright : of.base;
    case WildRadiances::Kind::rarely_lit:
      return chance < of.share ? of.base * of.bright : pt::Rgb{};
    case WildRadiances::Kind::exponential:
      return of.base * std::exp(3 * (chance + other - 1));
    case WildRadiances::Kind::spikes:
      return chance < of.share ? of.base * of.bright : of.base * other;
  }
  return {};
}

}  // namespace

std::vector<pt::Rgb> WildRadiances::values(int n) const {
  pt::Sampler random(seed);
  std::vector<pt::Rgb> all;
  for (int i = 0; i < n; ++i) {
    const double chance = random.next_1d();
    all.push_back(radiance_of(*this, chance, random.next_1d()));
  }
  return all;
}

std::string WildRadiances::text() const {
  const std::string times =
      fmt::format("{} times as much with probability {:.4f}", brief(bright), share);
  switch (kind) {
    case Kind::constant:
      return fmt::format("radiances: always {}", brief(base));
    case Kind::uniform:
      return fmt::format("radiances: {} times a uniform number", brief(base));
    case Kind::two_values:
      return fmt::format("radiances: {}, and {}", brief(base), times);
    case Kind::rarely_lit:
      return fmt::format("radiances: black, but {} with probability {:.4f}", brief(base * bright),
                         share);
    case Kind::spikes:
      return fmt::format("radiances: {} times a uniform number, and {}", brief(base), times);
    case Kind::exponential:
      return fmt::format("radiances: {} times exp(3 (a + b - 1)), a and b uniform", brief(base));
  }
  return "";
}

WildRadiances wild_radiances(RandomNumbers& random) {
  using Kind = WildRadiances::Kind;
  WildRadiances made;
  made.kind = std::array{Kind::constant,   Kind::uniform,     Kind::two_values,
                         Kind::rarely_lit, Kind::exponential, Kind::spikes}[random.whole(0, 5)];
  made.share = by_size(random, 1e-3, 0.5);
  made.bright = by_size(random, 1.01, 1e6);
  const double r = random.between(0.1, 1), g = random.between(0.1, 1);
  made.base = pt::Rgb{r, g, random.between(0.1, 1)} * by_size(random, 1e-3, 1e3);
  made.seed = static_cast<std::uint64_t>(random.between(0, 1e15));
  return made;
}

WildRadiances rarely_bright(RandomNumbers& random) {
  WildRadiances made = wild_radiances(random);
  made.kind =
      by_chance(random, 0.5) ? WildRadiances::Kind::rarely_lit : WildRadiances::Kind::spikes;
  made.share = by_size(random, 1e-3, 1e-2);
  made.bright = by_size(random, 1e2, 1e6);
  return made;
}

}  // namespace grader::check
