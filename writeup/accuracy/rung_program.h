#pragma once

#include "grader/base/descriptor.h"
#include "writeup/accuracy/rung_wire.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <sys/types.h>

namespace writeup::accuracy {

// A program with the implementations of one rung, which has loaded the scene and renders what it is
// asked for. It ends with this object.
class RungProgram {
 public:
  // `mixture` as ./run --from writes it, "reference+hit_bvh=iterative"; its program stands in the
  // folder. Throws pt::Error if there is none.
  RungProgram(const std::filesystem::path& folder, const std::string& mixture,
              const Options& options, pt::Engine engine);
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

}  // namespace writeup::accuracy
