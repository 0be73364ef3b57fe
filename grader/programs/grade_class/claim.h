#pragma once

#include "grader/base/descriptor.h"

#include <string>

namespace grader::programs {

// While this lives, no other process and no other thread has a claim on the same name in the same
// folder; to make one waits for that. A claim ends with its process, however that ends. It holds
// between machines that share the folder where the file system has locks (NFS has).
class Claim {
 public:
  Claim(const std::string& folder, const std::string& name);

 private:
  base::Descriptor file_;
};

}  // namespace grader::programs
