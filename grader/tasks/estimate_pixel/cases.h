#pragma once

#include "grader/property/cameras.h"
#include "grader/property/generators.h"
#include "grader/property/show.h"
#include "grader/stand_ins/scripted_radiance.h"
#include "pt/tasks/estimate_pixel.h"

#include <string>
#include <utility>
#include <vector>

// Pixels of pictures of any shape, and what estimate_pixel asked of radiance() for them.

namespace grader::estimate_pixel_cases {

struct Pixel {
  pt::Camera camera;
  int width = 0, height = 0;
  int x = 0, y = 0;
};

inline void showValue(const Pixel& p, std::ostream& out) {
  out << show(p.camera) << "\npixel (" << p.x << ", " << p.y << ") of " << p.width << " x "
      << p.height;
}

inline rc::Gen<Pixel> pixel() {
  return rc::gen::exec([] {
    Pixel p;
    p.camera = *camera();
    std::tie(p.width, p.height) =
        *rc::gen::element(std::pair{2, 1}, std::pair{1, 3}, std::pair{64, 32}, std::pair{7, 500});
    p.x = *whole(0, p.width - 1);
    p.y = *whole(0, p.height - 1);
    return p;
  });
}

inline pt::PathSettings some_settings() {
  pt::PathSettings s;
  s.light_samples = draw("light samples", whole(2, 9));
  s.direct = pt::PathSettings::Direct::hemisphere;
  s.survival = draw("survival", real(0.2, 0.6));
  s.from = draw("from", whole(1, 3));
  s.to = s.from + draw("more bounces", whole(1, 6));
  s.show_normals = draw("normals", rc::gen::element(false, true));
  return s;
}

using Script = std::function<pt::Rgb(int call, const pt::Ray& ray)>;

// What one call of the task returned and did.
struct Estimate {
  pt::Rgb mean;
  std::vector<RadianceCall> calls;
  pt::Sampler sampler;  // afterwards
};

inline Estimate estimate(const Pixel& p, int samples, pt::Sampler sampler,
                         const Script& script = {}, const pt::PathSettings& settings = {}) {
  const pt::Scene scene;
  const pt::View view{scene, p.camera, settings, p.width, p.height};
  script_radiance(script);
  const pt::Rgb mean = pt::estimate_pixel(view, p.x, p.y, samples, sampler);
  return {mean, radiance_calls(), sampler};
}

// Where a ray goes through the pixel: (0, 0) is its lower left corner, (1, 1) its upper right one.
inline pt::Vec2 in_pixel(const Pixel& p, const pt::Ray& ray) {
  const pt::Vec2 at = on_picture(p.camera, ray.direction);
  return {at.x * p.width - p.x, at.y * p.height - p.y};
}

}  // namespace grader::estimate_pixel_cases
