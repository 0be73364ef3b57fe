#pragma once

#include "grader/mistakes/battery.h"
#include "pt/math/frame.h"
#include "pt/scene/view.h"

#include <algorithm>
#include <vector>

// Code that the batteries of estimate_pixel and adaptive_pixel share.

namespace grader::mistakes {

// A pixel, and the size of its picture.
struct Place {
  int x = 0, y = 0, width = 1, height = 1;
};

inline constexpr Place kPlaces[] = {{0, 0, 1, 1}, {3, 5, 8, 6}, {6, 0, 7, 50}};

inline pt::Camera fixed_camera() {
  pt::Camera camera;
  camera.position = {1, 2, 3};
  const pt::Frame around = pt::frame_from_normal(normalize(pt::Vec3{1, -2, 2}));
  camera.camera_to_world = {around.z, around.x, around.y};
  camera.hfov_deg = 60;
  camera.vfov_deg = 40;
  camera.near_clip = 0.5;
  camera.far_clip = 20;
  return camera;
}

// The path settings that radiance() should receive. None of them has its default value.
inline pt::PathSettings fixed_settings() {
  pt::PathSettings settings;
  settings.light_samples = 5;
  settings.direct = pt::PathSettings::Direct::hemisphere;
  settings.survival = 0.4;
  settings.from = 2;
  settings.to = 6;
  settings.show_normals = true;
  return settings;
}

// Returns the mean over the points of a pixel: their coordinates, products of these, and the share
// of points outside. Without points, all are 0.
inline Battery::Numbers mean_place(const std::vector<pt::Vec2>& points) {
  Battery::Numbers mean(6);
  for (const auto [x, y] : points) {
    const bool outside = !(std::min(x, y) > -1e-6 && std::max(x, y) < 1 + 1e-6);
    const Battery::Numbers row{x, y, x * x, y * y, x * y, flag(outside)};
    for (std::size_t i = 0; i < row.size(); ++i) {
      mean[i] += row[i] / static_cast<double>(points.size());
    }
  }
  return mean;
}

}  // namespace grader::mistakes
