#include "pt/tasks/estimate_pixel.h"

#include "grader/mistakes/battery.h"
#include "grader/mistakes/pixels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace grader::mistakes {
namespace {

using namespace check;

using pt::Rgb;

Rgb color(int i) { return {noise(i), 2 * noise(i + 1000), 4 * noise(i + 2000)}; }

using Script = std::function<Rgb(int call)>;

Rgb estimate(const Pixel& p, int samples, pt::Sampler& sampler, const Script& script = color) {
  const pt::Scene scene;
  const pt::View view{scene, some_camera(), some_settings(), p.width, p.height};
  script_radiance([&](int call, const pt::Ray&) { return script(call); });
  return pt::estimate_pixel(view, p.x, p.y, samples, sampler);
}

Rgb estimate(const Pixel& p, int samples, std::uint64_t seed, const Script& script = color) {
  pt::Sampler sampler = pt::Sampler::for_pixel(seed, p.x, p.y);
  return estimate(p, samples, sampler, script);
}

// The mean, the number of samples, and the settings that radiance() got.
void means(Battery& battery) {
  for (const Pixel& p : kPixels) {
    for (const int samples : {1, 2, 3, 4, 5, 9, 16, 25, 64}) {
      battery.ask([&]() -> Battery::Numbers {
        const Rgb mean = estimate(p, samples, 1);
        const auto& calls = radiance_calls();
        const pt::PathSettings expected = some_settings();
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
  const auto ask = [&](double unit, const Script& script) {
    battery.ask([&]() -> Battery::Numbers {
      const Rgb mean = estimate(kPixels[1], kSamples, 1, script) / unit;
      return {mean.r, mean.g, mean.b, static_cast<double>(radiance_calls().size())};
    });
  };
  for (const double unit : {1e-8, 1e-4, 1e3}) {
    ask(unit, [=](int i) { return unit * color(i); });
  }
  ask(1e3, [](int i) { return (i == kSamples / 2 ? 1e4 : 1) * color(i); });
}

void one_sample(Battery& battery) {
  for (const Pixel& p : kPixels) {
    battery.ask([&]() -> Battery::Numbers {
      estimate(p, 1, 1);
      if (radiance_calls().empty()) return {};
      const auto [x, y] = in_pixel(p, radiance_calls()[0].ray);
      const pt::Vec3 o = radiance_calls()[0].ray.origin;
      return {x, y, o.x, o.y, o.z};
    });
  }
}

// One row per call, because the points of one call need not be independent.
void where(Battery& battery) {
  struct {
    int samples, calls;
  } constexpr kSizes[] = {{2, 200}, {9, 60}, {64, 30}};
  for (const Pixel& p : kPixels) {
    for (const auto& [samples, calls] : kSizes) {
      battery.mean(calls, [&, each = samples](int n, std::uint64_t seed) {
        std::vector<Battery::Numbers> rows;
        for (int i = 0; i < n; ++i) {
          estimate(p, each, seed + i);
          rows.push_back(mean_place(p));
        }
        return rows;
      });
    }
  }
}

// Flags: the same sampler gives the same points, and another one other points; the caller's sampler
// goes on; radiance() gets this sampler; and nothing is remembered from the calls before.
void streams(Battery& battery) {
  battery.ask([&]() -> Battery::Numbers {
    const Pixel p = kPixels[1];
    const auto look = [&](std::uint64_t seed) {
      const Rgb mean = estimate(p, 4, seed);
      return std::pair(mean.r, mean_place(p));
    };
    const auto first = look(5), other = look(6), again = look(5);
    const pt::Sampler start(7);
    pt::Sampler after = start;
    estimate(p, 4, after);
    const auto& calls = radiance_calls();
    const bool same = !calls.empty() && calls.back().sampler == after.state();
    estimate(p, 4, 5, [](int i) { return 3 * color(i); });
    const double after_bright = estimate(p, 4, 5).r;
    return {flag(first == again), flag(first.second == other.second),
            flag(after.state() != start.state()), flag(same), flag(after_bright == first.first)};
  });
}

// The points of a call in the only pixel of a picture, where points are precise.
std::vector<pt::Vec2> points_of_call(int samples) {
  estimate(kPixels[0], samples, 1, [](int) { return Rgb{}; });
  std::vector<pt::Vec2> points;
  for (const RadianceCall& call : radiance_calls()) {
    points.push_back(in_pixel(kPixels[0], call.ray));
  }
  return points;
}

// Flags: all points of a call are the same, or are on a grid.
void grids(Battery& battery) {
  battery.ask([&]() -> Battery::Numbers {
    const std::vector<pt::Vec2> points = points_of_call(64);
    const auto all_on_a_grid = [&](int places) {
      return std::ranges::all_of(points, [=](pt::Vec2 at) {
        const double x = places * at.x, y = places * at.y;
        return std::max(std::abs(x - std::round(x)), std::abs(y - std::round(y))) < 0.01;
      });
    };
    const bool all_the_same = std::ranges::all_of(points, [&](pt::Vec2 at) {
      return std::abs(at.x - points[0].x) + std::abs(at.y - points[0].y) < 1e-4;
    });
    return {flag(all_the_same), flag(all_on_a_grid(32)), flag(all_on_a_grid(256))};
  });
}

// The number of samples, where many are requested. Flags: some points are outside of the pixel, some
// close to an edge, some close to the right edge, and many in the centre. Of right solutions, less
// than one in 30,000 has no points at the edges.
void many_samples(Battery& battery) {
  constexpr int kSamples = 7000;
  battery.ask([&]() -> Battery::Numbers {
    const std::vector<pt::Vec2> points = points_of_call(kSamples);
    const double n = static_cast<double>(points.size());
    if (points.size() != kSamples) return {n};
    int outside = 0, at_an_edge = 0, at_the_right = 0, central = 0;
    for (const auto [x, y] : points) {
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
