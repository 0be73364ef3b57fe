#pragma once

#include <string>

#include <fmt/format.h>

// Numbers as tables and sentences have them.

namespace measure {

// Three digits: "0.0123", "12345".
inline std::string digits(double value) {
  return value >= 100 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

// "12.3 %".
inline std::string percent(double part) { return digits(100 * part) + " %"; }

}  // namespace measure
