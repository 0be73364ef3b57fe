#pragma once

#include "pt/scene/camera.h"
#include "pt/scene/load_collada.h"

#include <filesystem>
#include <string>

namespace pt {

struct CyclesSettings {
  int width = 0;
  int height = 0;
  int bounces = 5;  // as PathSettings::to counts: 1 is direct light
  int threads = 1;
  int sphere_level = 6;  // of each sphere's mesh: 20 x 4^(level - 1) triangles
};

// Returns the loaded scene and its camera in JSON for bench/cycles.py. Throws Error, naming `file`, for a light
// that Cycles does not get: the sky, and an area light without a surface.
std::string cycles_scene(const LoadedScene& loaded, const std::filesystem::path& file,
                         const Camera& camera, const CyclesSettings& settings);

}  // namespace pt
