#pragma once

#include "pt/scene/frame_camera.h"
#include "pt/scene/tracer.h"
#include "pt/scene/view.h"
#include "pt/tasks/adaptive_pixel.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace pt {

enum class Show { full, direct, indirect, bounce, normals };

// The options of the render program.
struct RenderOptions {
  std::filesystem::path scene;
  std::filesystem::path output;
  int width = 480;
  int height = 360;
  int samples = 32;
  int light_samples = 1;
  int bounces = 5;
  std::optional<AdaptiveSettings> adaptive;
  double survival = 0.7;  // of Russian roulette
  bool hemisphere = false;
  Show show = Show::full;
  int bounce = 1;  // for Show::bounce
  Engine engine = Engine::task;
  int max_leaf = 4;
  Framing framing = Framing::course;
  bool lambertian = false;
  double exposure = 1;
  std::uint64_t seed = 0;
  int threads = 1;
};

// Reads the command line. Prints help and exits for --help, throws pt::Error for what it cannot
// use.
RenderOptions parse_options(int argc, const char* const* argv);

PathSettings path_settings(const RenderOptions& options);

}  // namespace pt
