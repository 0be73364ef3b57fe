#include "pt/tasks/estimate_pixel.h"

#include "grader/mistakes/battery.h"
#include "grader/mistakes/pixels.h"

namespace grader::mistakes {
namespace {

using namespace check;

using pt::Rgb;

pt::PathSettings some_settings() {
  pt::PathSettings s;
  s.light_samples = 5;
  s.direct = pt::PathSettings::Direct::hemisphere;
  s.survival = 0.4;
  s.from = 2;
  s.to = 6;
  s.show_normals = true;
  return s;
}

Rgb color(int i) { return {noise(i), 2 * noise(i + 1000), 4 * noise(i + 2000)}; }

Rgb estimate(const Pixel& p, int samples, pt::Sampler& sampler, double factor = 1) {
  const pt::Scene scene;
  const pt::View view{scene, some_camera(), some_settings(), p.width, p.height};
  script_radiance([&](int call, const pt::Ray&) { return factor * color(call); });
  return pt::estimate_pixel(view, p.x, p.y, samples, sampler);
}

Rgb estimate(const Pixel& p, int samples, std::uint64_t seed, double factor = 1) {
  pt::Sampler sampler = pt::Sampler::for_pixel(seed, p.x, p.y);
  return estimate(p, samples, sampler, factor);
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
    estimate(p, 4, 5, 3);
    const double after_bright = estimate(p, 4, 5).r;
    return {flag(first == again), flag(first.second == other.second),
            flag(after.state() != start.state()), flag(same), flag(after_bright == first.first)};
  });
}

}  // namespace

void run_battery(Battery& battery) {
  means(battery);
  one_sample(battery);
  where(battery);
  streams(battery);
}

}  // namespace grader::mistakes
