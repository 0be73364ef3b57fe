#pragma once

#include "pt/image/film.h"

#include <filesystem>
#include <string>
#include <vector>

// The files of a picture: for the eye, for a page's script, and for other programs.

namespace writeup {

// NAME.png, NAME.exr and NAME.js. Pixels without samples are hatched. The EXR has 11 bits of each
// number, which halves its size.
void write_film(const std::filesystem::path& name, const pt::Film& film, double exposure);

// One number per pixel, in colours from `low` to `high`: NAME.png, NAME.csv and NAME.js.
void write_map(const std::filesystem::path& name, const std::vector<float>& values, int width,
               float low, float high);

// Copies a file of a measurement into the folder under another name, which it adds to the list; a .tex names the PDF that is
// copied beside it. Without such a file, as where there is no gnuplot, it does nothing.
void take_file(const std::filesystem::path& from, const std::filesystem::path& folder,
               const std::string& name, std::vector<std::string>& list);

}  // namespace writeup
