#pragma once

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

// A scene file with the course's framing. Materials outside the model become diffuse.
TestScene file_scene(const std::string& file, int width, int height);

}  // namespace pt
