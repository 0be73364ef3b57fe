#include "grader/mistakes/battery.h"

#include "grader/mistakes/pixels.h"
#include "grader/tasks/estimate_pixel/inputs.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace grader::mistakes {
namespace {

using namespace check;

using namespace estimate_pixel_inputs;

Seen colors(double scale) { return {"all different", scale, 99}; }

Pixel pixel_at(const Place& place) {
  return {fixed_camera(), place.width, place.height, place.x, place.y};
}

Estimate estimate(const Place& place, int samples, std::uint64_t seed,
                  const RadianceScript& script) {
  const pt::Sampler sampler = pt::Sampler::for_pixel(seed, place.x, place.y);
  return estimate(pixel_at(place), samples, sampler, script, fixed_settings());
}

Estimate estimate(const Place& place, int samples, std::uint64_t seed) {
  return estimate(place, samples, seed, script_of(colors(2), samples));
}

std::vector<pt::Vec2> points(const Place& place, int samples, std::uint64_t seed) {
  return points_of(pixel_at(place), estimate(place, samples, seed));
}

// The mean, the number of samples, and the settings that radiance() got.
void means(Battery& battery) {
  for (const Place& place : kPlaces) {
    for (const int samples : {1, 2, 3, 4, 5, 9, 16, 25, 64}) {
      battery.ask([&]() -> Battery::Numbers {
        const auto [mean, calls, sampler] = estimate(place, samples, 1);
        const pt::PathSettings expected = fixed_settings();
        bool from = true, to = true, direct = true, lights = true, survival = true, normals = true;
        for (const RadianceCall& call : calls) {
          from = from && call.settings.from == expected.from;
          to = to && call.settings.to == expected.to;
          direct = direct && call.settings.direct == expected.direct;
          lights = lights && call.settings.light_samples == expected.light_samples;
          survival = survival && call.settings.survival == expected.survival;
          normals = normals && call.settings.show_normals;
        }
        return {mean.r,         mean.g,       mean.b,       static_cast<double>(calls.size()),
                flag(from),     flag(to),     flag(direct), flag(lights),
                flag(survival), flag(normals)};
      });
    }
  }
}

// The mean of bright and of dark samples, and of one bright sample among others, in units of their
// brightness. The number of samples makes the comparison less strict.
void brightness(Battery& battery) {
  constexpr int kSamples = 16;
  const auto ask = [&](double unit, const RadianceScript& script) {
    battery.ask([&]() -> Battery::Numbers {
      const Estimate e = estimate(kPlaces[1], kSamples, 1, script);
      const pt::Rgb mean = e.mean / unit;
      return {mean.r, mean.g, mean.b, static_cast<double>(e.calls.size())};
    });
  };
  for (const double unit : {1e-8, 1e-4, 1e3}) ask(unit, script_of(colors(2 * unit), kSamples));
  RadianceScript with_a_firefly = script_of(colors(2), kSamples);
  with_a_firefly.values[kSamples / 2] *= 1e4;
  ask(1e3, with_a_firefly);
}

void one_sample(Battery& battery) {
  for (const Place& place : kPlaces) {
    battery.ask([&]() -> Battery::Numbers {
      const Estimate e = estimate(place, 1, 1);
      if (e.calls.empty()) return {};
      const auto [x, y] = in_pixel(pixel_at(place), e.calls[0].ray);
      const pt::Ray& ray = e.calls[0].ray;
      const pt::Vec3 o = ray.origin;
      return {x, y, o.x, o.y, o.z, ray.t_min, 1 / ray.t_max};
    });
  }
}

// One row per call, because the points of one call need not be independent.
void where(Battery& battery) {
  struct {
    int samples, calls;
  } constexpr kSizes[] = {{2, 200}, {9, 60}, {64, 30}};
  for (const Place& place : kPlaces) {
    for (const auto& [samples, calls] : kSizes) {
      battery.mean(calls, [&, each = samples](int n, std::uint64_t seed) {
        std::vector<Battery::Numbers> rows;
        for (int i = 0; i < n; ++i) rows.push_back(mean_place(points(place, each, seed + i)));
        return rows;
      });
    }
  }
}

// Flags: the same sampler gives the same points, and another sampler other points; the caller's
// sampler goes on; radiance() gets this sampler; and nothing is remembered from the calls before.
void streams(Battery& battery) {
  battery.ask([&]() -> Battery::Numbers {
    const Place place = kPlaces[1];
    const auto look = [&](std::uint64_t seed) {
      const Estimate e = estimate(place, 4, seed);
      return std::pair(e.mean.r, mean_place(points_of(pixel_at(place), e)));
    };
    const auto first = look(5), other = look(6), again = look(5);
    const pt::Sampler start(7);
    const Estimate e =
        estimate(pixel_at(place), 4, start, script_of(colors(2), 4), fixed_settings());
    const bool same = !e.calls.empty() && e.calls.back().sampler == e.sampler.state();
    estimate(place, 4, 5, script_of(colors(6), 4));
    const double after_bright = look(5).first;
    return {flag(first == again), flag(first.second == other.second),
            flag(e.sampler.state() != start.state()), flag(same),
            flag(after_bright == first.first)};
  });
}

// Flags: all points of a call are the same, or are on a grid.
void grids(Battery& battery) {
  battery.ask([&]() -> Battery::Numbers {
    // In the only pixel of a picture, points are precise.
    const std::vector<pt::Vec2> all = points(kPlaces[0], 64, 1);
    const auto all_on_a_grid = [&](int places) {
      return std::ranges::all_of(all, [=](pt::Vec2 at) {
        const double x = places * at.x, y = places * at.y;
        return std::max(std::abs(x - std::round(x)), std::abs(y - std::round(y))) < 0.01;
      });
    };
    const bool all_the_same = std::ranges::all_of(all, [&](pt::Vec2 at) {
      return std::abs(at.x - all[0].x) + std::abs(at.y - all[0].y) < 1e-4;
    });
    return {flag(all_the_same), flag(all_on_a_grid(32)), flag(all_on_a_grid(256))};
  });
}

// The number of samples, if many are requested. Flags: some points are outside of the pixel, some
// close to an edge, some close to the right edge, and many in the centre. Less than one right
// solution in 30,000 has no points at the edges.
void many_samples(Battery& battery) {
  constexpr int kSamples = 7000;
  battery.ask([&]() -> Battery::Numbers {
    const std::vector<pt::Vec2> all = points(kPlaces[0], kSamples, 1);
    const double n = static_cast<double>(all.size());
    if (all.size() != kSamples) return {n};
    int outside = 0, at_an_edge = 0, at_the_right = 0, central = 0;
    for (const auto [x, y] : all) {
      const double edge = std::min({x, y, 1 - x, 1 - y});  // its distance, if inside
      if (edge < -1e-4) ++outside;
      if (edge < 4.5e-4) ++at_an_edge;
      if (x > 0.9981) ++at_the_right;
      if (std::abs(x - 0.5) + std::abs(y - 0.5) < 1e-4) ++central;
    }
    return {n, flag(outside > 0), flag(at_an_edge > 0), flag(at_the_right > 1),
            flag(central > kSamples / 10)};
  });
}

}  // namespace

void run_battery(Battery& battery) {
  means(battery);
  brightness(battery);
  one_sample(battery);
  where(battery);
  grids(battery);
  many_samples(battery);
  streams(battery);
}

}  // namespace grader::mistakes
