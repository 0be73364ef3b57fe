#pragma once

#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"
#include "pt/scene/tracer.h"
#include "pt/scene/view.h"
#include "pt/tasks/adaptive_pixel.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace pt {

enum class Show { full, direct, indirect, bounce, normals };

// The options of the render program.
struct RenderOptions {
  std::filesystem::path scene;
  std::filesystem::path output;
  std::filesystem::path resume;   // an .exr to go on with; or empty
  std::optional<double> seconds;  // of --time
  std::filesystem::path
      notes;  // a file for what is said of the picture, for ./run compare; or empty
  int width = 480;
  int height = 360;
  int samples = 32;
  PathSettings path;  // its light samples and its survival
  int bounces = 5;
  std::optional<AdaptiveSettings> adaptive;
  bool hemisphere = false;
  Show show = Show::full;
  int bounce = 1;  // for Show::bounce
  Engine engine = Engine::task;
  int max_leaf = 4;
  Framing framing = Framing::course;
  LoadOptions load;
  double exposure = 1;
  std::uint64_t seed = 0;
  int threads = 1;
};

// Reads the command line. Prints help and exits for --help. Throws pt::Error if it cannot be used.
RenderOptions parse_options(int argc, const char* const* argv);

PathSettings path_settings(const RenderOptions& options);

// The words after --engine, --camera and --light, in every program that has them.
inline const std::map<std::string, Engine> kEngineWords{
    {"linear", Engine::linear}, {"task", Engine::task}, {"wide", Engine::wide}};
inline const std::map<std::string, Framing> kFramingWords{
    {"course", Framing::course}, {"fit", Framing::fit}, {"file", Framing::file}};
inline constexpr const char* kCourseLightHelp =
    "course: area lights as in CS184's skeleton, whose density lacks a factor of the distance";
inline const std::map<std::string, LightChoice> kLightWords{{"file", LightChoice::file},
                                                            {"course", LightChoice::course},
                                                            {"sky", LightChoice::sky},
                                                            {"camera", LightChoice::camera}};

}  // namespace pt
