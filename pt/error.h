#pragma once

#include <stdexcept>
#include <string>

namespace pt {

// Input that cannot be used: the message is one sentence for the person who gave it, with file,
// line and what to do. Thrown where it is noticed, caught once, in main, which exits with 2.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace pt
