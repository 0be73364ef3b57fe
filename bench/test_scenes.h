#pragma once

#include "pt/geometry/ray.h"
#include "pt/scene/camera.h"
#include "pt/scene/scene.h"

#include <string>
#include <vector>

namespace pt {

// A scene to trace, without a tracer, and its camera.
struct TestScene {
  std::string name;
  Scene scene;
  Camera camera;
};

// A bumpy blob of about `triangles` triangles in a Cornell box, under a rectangular light.
TestScene blob_scene(int triangles);

// The same box with so many triangles a hundred times as long as wide, in all directions: the boxes around
// them hold next to nothing else.
TestScene needles_scene(int triangles);

// A scene file with the course's framing. Materials outside the model become diffuse.
TestScene file_scene(const std::string& file, int width, int height);

// The rays that a path tracer would trace in a scene, by kind. Shadow rays come in groups of
// kShadowGroup from one point.
inline constexpr int kShadowGroup = 8;
struct RaySets {
  std::vector<Ray> primary;
  std::vector<Ray> bounce;
  std::vector<Ray> shadow;
};

// Makes about `count` rays of each kind with the scene's tracer. Primary rays go through random
// points of the pixels of a 480 x 360 picture, in order. The others start in turn at the hits of
// primary rays, and after one bounce.
RaySets make_rays(const TestScene& test, int count);

}  // namespace pt
