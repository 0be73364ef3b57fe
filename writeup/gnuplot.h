#pragma once

#include <filesystem>
#include <string>

namespace writeup {

// Draws <folder>/<name>.svg by gnuplot, in the style of the write-up, from commands that read their
// numbers in that folder. Does nothing where there is no gnuplot.
void draw(const std::filesystem::path& folder, const std::string& name,
          const std::string& commands);

// Colors of lines that belong together: blue, green, red; each from dark to light.
enum class Hue { blue, green, red };
inline constexpr int kShades = 6;
const char* color(Hue hue, int shade);

}  // namespace writeup
