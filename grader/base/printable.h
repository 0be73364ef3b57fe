#pragma once

#include <string>
#include <string_view>

namespace grader::base {

// Text from outside, fit to be shown: control characters, which could move a terminal's cursor or
// start a new line, become spaces (but newlines and tabs may stay), and what is longer than `most`
// is cut.
inline std::string printable(std::string_view text, std::size_t most, bool lines = false) {
  std::string clean;
  for (const char c : text.substr(0, most)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool keeps = lines && (c == '\n' || c == '\t');
    clean += keeps || (byte >= 0x20 && byte != 0x7f) ? c : ' ';
  }
  if (text.size() > most) clean += " ...";
  return clean;
}

}  // namespace grader::base
