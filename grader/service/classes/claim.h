#pragma once

#include "grader/base/descriptor.h"

#include <string>

namespace grader::classes {

// While a claim lives, no other process or thread has one on the same name in the same folder; the
// constructor waits until the name is free. A claim ends with its process, however that ends. It also holds
// between machines that share the folder, if the file system has locks (NFS has).
class Claim {
 public:
  Claim(const std::string& folder, const std::string& name);

 private:
  base::Descriptor file_;
};

}  // namespace grader::classes
