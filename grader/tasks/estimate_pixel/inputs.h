#pragma once

#include "grader/check/generators/cameras.h"
#include "grader/check/generators/generators.h"
#include "grader/check/generators/views.h"
#include "grader/check/language/cases.h"
#include "grader/check/language/show.h"
#include "grader/check/mocks/scripted_radiance.h"
#include "pt/tasks/estimate_pixel.h"

#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Pixels of pictures of any shape, and the calls of radiance() that estimate_pixel makes for them.

namespace grader::check::estimate_pixel_inputs {

struct Pixel {
  pt::Camera camera;
  int width = 0, height = 0;
  int x = 0, y = 0;
};

inline void showValue(const Pixel& p, std::ostream& out) {
  out << show(p.camera) << "\npixel (" << p.x << ", " << p.y << ") of " << p.width << " x "
      << p.height;
}

// An index in 0 .. count - 1. The first and the last are more frequent.
inline int one_of(int count) {
  switch (*whole(0, 3)) {
    case 0:
      return 0;
    case 1:
      return count - 1;
    default:
      return *whole(0, count - 1);
  }
}

inline rc::Gen<Pixel> pixel() {
  return rc::gen::exec([] {
    Pixel p;
    p.camera = *camera();
    std::tie(p.width, p.height) = *rc::gen::element(
        std::pair{2, 1}, std::pair{1, 3}, std::pair{64, 32}, std::pair{7, 500}, std::pair{1, 1},
        std::pair{1920, 1080}, std::pair{4000, 3000}, *many_pixels());
    p.x = one_of(p.width);
    p.y = one_of(p.height);
    return p;
  });
}

// A pixel of a picture that is three times as long as wide.
inline rc::Gen<Pixel> pixel_of_a_long_picture() {
  return rc::gen::exec([] {
    Pixel p;
    p.camera = *camera();
    std::tie(p.width, p.height) = *rc::gen::element(std::pair{48, 16}, std::pair{16, 48});
    p.x = *whole(0, p.width - 1);
    p.y = *whole(0, p.height - 1);
    return p;
  });
}

// A pixel of a picture with so few pixels that the error of a camera ray is far smaller than a
// pixel.
inline rc::Gen<Pixel> large_pixel() {
  return rc::gen::exec([] {
    Pixel p{*camera(), 8, 5, 0, 0};
    p.x = one_of(p.width);
    p.y = one_of(p.height);
    return p;
  });
}

// The one pixel of a picture. The error of a camera ray is some hundred-thousandths of it.
inline rc::Gen<Pixel> whole_picture() {
  return rc::gen::map(camera(), [](const pt::Camera& camera) { return Pixel{camera, 1, 1, 0, 0}; });
}

inline pt::Vec2 slack(const Pixel& p) { return ray_slack(p.camera, p.width, p.height); }

// The values that radiance() returns, one per sample of a pixel.
struct Seen {
  std::string kind;
  double scale = 1;
  std::uint64_t seed = 0;

  pt::Rgb at(int call) const {
    pt::Sampler random = pt::Sampler::for_pixel(seed, call, 0);
    const double chance = random.next_1d();
    const pt::Vec2 rg = random.next_2d();
    const pt::Rgb color = scale * pt::Rgb{0.1 + rg.x, 0.1 + rg.y, 0.1 + random.next_1d()};
    if (kind == "all black") return {};
    if (kind == "all alike") return scale * pt::Rgb{0.1, 0.7, 1};
    if (kind == "mostly black") return chance < 0.8 ? pt::Rgb{} : color;
    if (kind == "some a thousand times brighter") return chance < 0.2 ? 1e3 * color : color;
    return color;
  }
};

inline void showValue(const Seen& seen, std::ostream& out) {
  out << "radiances of about " << show(seen.scale) << ", " << seen.kind << ": " << show(seen.at(0))
      << ", " << show(seen.at(1)) << " ...";
}

inline rc::Gen<Seen> any_radiances() {
  return rc::gen::exec([] {
    const auto kind = *rc::gen::element<std::string>("all different", "all alike", "mostly black",
                                                     "some a thousand times brighter", "all black");
    return Seen{kind, *magnitude(1e-12, 1e6), *sampler_seed()};
  });
}

// The radiances of so many samples.
inline RadianceScript script_of(const Seen& seen, int samples) {
  RadianceScript script;
  for (int i = 0; i < samples; ++i) script.values.push_back(seen.at(i));
  return script;
}

// The result of one call of the task, and the calls of radiance() that it made.
struct Estimate {
  pt::Rgb mean;
  std::vector<RadianceCall> calls;
  pt::Sampler sampler;  // its state after the call
};

inline Estimate estimate(const Pixel& p, int samples, pt::Sampler sampler,
                         const RadianceScript& script = {}, const pt::PathSettings& settings = {},
                         const pt::Scene& scene = {}) {
  const pt::View view{scene, p.camera, settings, p.width, p.height};
  script_radiance(script);
  const pt::Rgb mean = pt::estimate_pixel(view, p.x, p.y, samples, sampler);
  return {mean, radiance_calls(), sampler};
}

// Returns where a ray goes through the pixel: (0, 0) is its lower left corner, (1, 1) its upper
// right one.
inline pt::Vec2 in_pixel(const Pixel& p, const pt::Ray& ray) {
  const pt::Vec2 at = on_picture(p.camera, ray.direction);
  return {at.x * p.width - p.x, at.y * p.height - p.y};
}

// Returns where all rays of a call go through the pixel.
inline std::vector<pt::Vec2> points_of(const Pixel& p, const Estimate& e) {
  std::vector<pt::Vec2> points;
  for (const RadianceCall& call : e.calls) points.push_back(in_pixel(p, call.ray));
  return points;
}

// All arguments of a call, in a scene with so many lights.
struct Call {
  Pixel pixel;
  int samples = 1;
  pt::PathSettings settings{};
  int lights = 0;
  Seen seen{};
  std::uint64_t seed = 0;
};

inline void showValue(const Call& c, std::ostream& out) {
  showValue(c.pixel, out);
  out << "\nsamples: " << c.samples << ", lights: " << c.lights << ", seed: " << c.seed << '\n'
      << show(c.settings) << '\n';
  showValue(c.seen, out);
}

inline Estimate call(const Call& c) {
  return estimate(c.pixel, c.samples, pt::Sampler(c.seed), script_of(c.seen, c.samples), c.settings,
                  scene_with(c.lights));
}

inline Cases<Call> calls() {
  return {rc::gen::exec([] {
    return Call{*pixel(),     *whole(1, 20),    *usual_settings(),
                *whole(0, 9), *any_radiances(), *sampler_seed()};
  })};
}

inline OtherCases<Call> other_counts() {
  return {[](Call& c) { ++c.samples; }, [](Call& c) { c.samples *= 2; },
          [](Call& c) { c.samples = c.samples / 2 + 1; }};
}

}  // namespace grader::check::estimate_pixel_inputs
