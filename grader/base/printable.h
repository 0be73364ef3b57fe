#pragma once

#include "pt/printable.h"

#include <string>
#include <string_view>

namespace grader::base {

// Makes text from outside printable (pt::printable), and cuts it after `most` bytes.
inline std::string printable(std::string_view text, std::size_t most, bool lines = false) {
  const std::string clean = pt::printable(pt::beginning(text, most), lines);
  return text.size() > most ? clean + " ..." : clean;
}

}  // namespace grader::base
