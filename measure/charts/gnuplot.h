#pragma once

#include <filesystem>
#include <string>

namespace measure {

// Draws <folder>/<name>.svg with gnuplot, in the style of the write-up, from commands that read
// their numbers in that folder. Does nothing without gnuplot.
void draw(const std::filesystem::path& folder, const std::string& name,
          const std::string& commands);

// Colours for three groups of lines: blue, green, red; each from dark to light.
enum class Hue { blue, green, red };
inline constexpr int kShades = 6;
const char* color(Hue hue, int shade);

}  // namespace measure
