#pragma once

#include "grader/base/descriptor.h"
#include "pt/image/image.h"
#include "pt/scene/camera.h"
#include "pt/scene/load_collada.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <nlohmann/json_fwd.hpp>
#include <sys/types.h>

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

// A picture, and the processor time that it took on all threads.
struct TimedImage {
  Image image;
  double cpu_seconds = 0;
};

// A running Blender that has one scene, and renders it on request. Throws Error with Blender's last message if
// Blender ends before it has answered.
class Cycles {
 public:
  // `blender` is a program. cycles_scene makes `scene`. `folder` receives the scene, pictures, and a log.
  Cycles(const std::filesystem::path& blender, const std::filesystem::path& folder,
         const std::string& scene);
  ~Cycles();
  Cycles(const Cycles&) = delete;
  Cycles& operator=(const Cycles&) = delete;

  // The time does not include writing and reading the file.
  TimedImage render(int samples, std::uint32_t seed);

  const std::string& version() const { return version_; }
  double start_cpu_seconds() const {
    return start_seconds_;
  }  // until the scene was loaded, without its tree

 private:
  nlohmann::json answer();

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::filesystem::path folder_;
  pid_t process_ = -1;
  grader::base::Descriptor jobs_;
  std::unique_ptr<std::FILE, Close> answers_;
  std::string version_;
  double start_seconds_ = 0;
};

}  // namespace pt
