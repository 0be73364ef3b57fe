#pragma once

#include "grader/base/descriptor.h"
#include "measure/renders/spec.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <sys/types.h>

namespace measure::scene {

// Some pixels of the picture, rendered once: `first`, and each `step`-th after it, of the list from
// spread_pixels() for the options of both programs. The spec only counts where there is no option.
struct RungRequest {
  Spec spec;
  std::size_t first = 0;
  std::size_t step = 1;
};

struct RungReply {
  double cpu_seconds = 0;    // of all threads
  long long rays = 0;        // of all pixels
  long long samples = 0;     // of all pixels
  std::vector<double> mean;  // of each pixel, luminance
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RungReply, cpu_seconds, rays, samples, mean)

// A program with the implementations of one rung. It has loaded the scene, and renders on request,
// one line of JSON per request. The destructor ends it.
class RungProgram {
 public:
  // `mixture` is as in ./run --from, "reference+hit_bvh=iterative". `command` is ladder's; the
  // program is in the same folder. Throws pt::Error if there is no such program.
  RungProgram(std::vector<std::string> command, const std::string& mixture, pt::Engine engine);
  RungProgram(const RungProgram&) = delete;
  RungProgram& operator=(const RungProgram&) = delete;
  ~RungProgram();

  // Throws pt::Error if the program has ended.
  RungReply render(const RungRequest& request);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::string name_;
  pid_t pid_ = -1;
  grader::base::Descriptor requests_;
  std::unique_ptr<std::FILE, Close> replies_;
};

}  // namespace measure::scene
