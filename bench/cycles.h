#pragma once

#include "grader/base/descriptor.h"
#include "pt/image/image.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <nlohmann/json_fwd.hpp>
#include <sys/types.h>

namespace pt {

// A picture, and the processor time of all threads that it took.
struct TimedImage {
  Image image;
  double cpu_seconds = 0;
};

// Blender with one scene in it, which renders when it is asked to. Throws Error, with Blender's own last words, if
// it ends before it has answered.
class Cycles {
 public:
  // `blender` is a program. `scene` is what cycles_scene returns. `folder` takes the scene, pictures, and a log.
  Cycles(const std::filesystem::path& blender, const std::filesystem::path& folder,
         const std::string& scene);
  ~Cycles();
  Cycles(const Cycles&) = delete;
  Cycles& operator=(const Cycles&) = delete;

  // The time does not include that of writing and reading the file.
  TimedImage render(int samples, std::uint32_t seed);

  const std::string& version() const { return version_; }
  double start_cpu_seconds() const {
    return start_seconds_;
  }  // until the scene was there, without its tree

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
