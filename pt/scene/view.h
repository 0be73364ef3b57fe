#pragma once

#include "pt/scene/camera.h"
#include "pt/scene/path_settings.h"
#include "pt/scene/scene.h"

namespace pt {

// A picture to render: the scene, the camera and the settings.
struct View {
  const Scene& scene;
  Camera camera;
  PathSettings settings;
  int width = 0;  // pixels
  int height = 0;
};

}  // namespace pt
