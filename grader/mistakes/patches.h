#pragma once

#include "grader/check/scenes/scenes.h"

#include <vector>

// The batteries of the lighting tasks share these inputs: a patch, poses, and lights.

namespace grader::mistakes {

inline constexpr pt::Rgb kAlbedo{0.9, 0.5, 0.2};
inline constexpr pt::Rgb kRadiance{1.5, 2, 3};
inline constexpr pt::Vec3 kTilted{0.6, 0, 0.8};  // wo

// A pose without a rotation. It only moves and scales.
inline check::Pose here(double size = 1, pt::Vec3 shift = {}) { return {{}, size * shift, size}; }

// A pose in which the normal of the shaded point is `n` in the world.
inline check::Pose turned(pt::Vec3 n, double size = 1) {
  return {pt::frame_from_normal(normalize(n)), size * pt::Vec3{3, 2, -1}, size};
}

// The same kind of pose far from the origin, where rounding errors of points are large.
inline check::Pose far_away(double size) {
  check::Pose pose = turned({1, 2, 3}, size);
  pose.shift = size * pt::Vec3{100, -70, 50};
  return pose;
}

// Poses as far from the origin as scenes may be. If a ray hardly leaves the surface, the rounding
// errors of the point decide whether it hits the surface again.
inline std::vector<check::Pose> farthest(double size) {
  std::vector<check::Pose> poses;
  for (const pt::Vec3 n :
       {pt::Vec3{1, 2, 3}, pt::Vec3{-1, 0.1, 0}, pt::Vec3{2, -3, 1}, pt::Vec3{-1, -2, -2}}) {
    poses.push_back(turned(n, size));
    poses.back().shift = size * pt::Vec3{9000, -7000, 5000};
  }
  return poses;
}

// Returns the shaded patch, to which lights and surfaces are added.
inline check::SceneMaker patch(const check::Pose& pose = here(), bool from_behind = false,
                               pt::Rgb emission = {}) {
  return check::SceneMaker(pose).patch(kAlbedo, kTilted, from_behind, emission);
}

// A plate close above the point.
inline const check::Rectangle kPlate{{0, 0, 0.01}, {0, 1, 0}, {1, 0, 0}};

// Rectangles straight above, tilted, and low at the side. All of them face the point.
inline const check::Rectangle kAbove{{0, 0, 1}, {0, 1.6, 0}, {2, 0, 0}};
inline const check::Rectangle kAside{{0.7, 0.2, 0.8}, {-0.2, 0.9, 0}, {0.8, 0, -0.5}};
inline const check::Rectangle kLow{{1, 0, 0.3}, {0, 0, 0.5}, {0, 1, 0}};

}  // namespace grader::mistakes
