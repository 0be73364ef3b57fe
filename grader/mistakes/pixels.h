#pragma once

#include "grader/check/cameras.h"
#include "grader/check/scripted_radiance.h"
#include "grader/mistakes/battery.h"

#include <algorithm>

// Code that the batteries of estimate_pixel and adaptive_pixel share.

namespace grader::mistakes {

struct Pixel {
  int x = 0, y = 0, width = 1, height = 1;
};

inline constexpr Pixel kPixels[] = {{0, 0, 1, 1}, {3, 5, 8, 6}, {6, 0, 7, 50}};

inline pt::Camera some_camera() {
  pt::Camera camera;
  camera.position = {1, 2, 3};
  const pt::Frame around = pt::frame_from_normal(normalize(pt::Vec3{1, -2, 2}));
  camera.camera_to_world = {around.z, around.x, around.y};
  camera.hfov_deg = 60;
  camera.vfov_deg = 40;
  return camera;
}

// The path settings that are to reach radiance(): none is the default.
inline pt::PathSettings some_settings() {
  pt::PathSettings settings;
  settings.light_samples = 5;
  settings.direct = pt::PathSettings::Direct::hemisphere;
  settings.survival = 0.4;
  settings.from = 2;
  settings.to = 6;
  settings.show_normals = true;
  return settings;
}

// A fixed stream of numbers in [0, 1).
inline double noise(int i) { return pt::Sampler::for_pixel(99, i, 0).next_1d(); }

// Returns where a ray goes through the pixel: (0, 0) is its lower left corner, (1, 1) its upper
// right one.
inline pt::Vec2 in_pixel(const Pixel& p, const pt::Ray& ray) {
  const pt::Vec2 at = check::on_picture(some_camera(), ray.direction);
  return {at.x * p.width - p.x, at.y * p.height - p.y};
}

// Returns one row per call of radiance(): its point in the pixel, products of the coordinates, and
// whether the point is outside.
inline std::vector<Battery::Numbers> places(const Pixel& p) {
  std::vector<Battery::Numbers> rows;
  for (const check::RadianceCall& call : check::radiance_calls()) {
    const auto [x, y] = in_pixel(p, call.ray);
    const bool outside = !(std::min(x, y) > -1e-6 && std::max(x, y) < 1 + 1e-6);
    rows.push_back({x, y, x * x, y * y, x * y, flag(outside)});
  }
  if (rows.empty()) rows.push_back({0, 0, 0, 0, 0, 0});
  return rows;
}

// Returns the mean of all rows.
inline Battery::Numbers mean_place(const Pixel& p) {
  const std::vector<Battery::Numbers> rows = places(p);
  Battery::Numbers mean(rows[0].size());
  for (const Battery::Numbers& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      mean[i] += row[i] / static_cast<double>(rows.size());
  }
  return mean;
}

}  // namespace grader::mistakes
