#pragma once

#include "pt/printable.h"

#include <string>
#include <string_view>

namespace grader::base {

// Text from outside as pt::printable has it, of which what is longer than `most` bytes is cut.
inline std::string printable(std::string_view text, std::size_t most, bool lines = false) {
  const std::string clean = pt::printable(pt::beginning(text, most), lines);
  return text.size() > most ? clean + " ..." : clean;
}

}  // namespace grader::base
