#pragma once

#include "pt/image/film.h"
#include "pt/image/image.h"
#include "pt/image/picture.h"

#include <filesystem>
#include <string>

// Pictures in files. Writers write a whole file or none (pt/file.h); all functions throw pt::Error
// for a path or a file they cannot use.

namespace pt {

// Throws pt::Error unless write_image knows the extension of `path` and could write there.
void check_image_target(const std::filesystem::path& path);

// Returns whether the name ends in .exr, in any case.
bool is_exr_name(const std::filesystem::path& path);

// Writes .png (the tone-mapped mean) or .exr (the whole film, without exposure, and the settings in its header), by the extension.
void write_image(const std::filesystem::path& path, const Film& film, double exposure = 1,
                 const std::string& settings = "");

// The bytes of a PNG file.
std::string encode_png(const Picture& picture);

void write_png(const std::filesystem::path& path, const Picture& picture);
void write_png(const std::filesystem::path& path, const Image& image, double exposure = 1);

// Scanlines, ZIP; 32-bit float channels R, G, B, Y (the means), variance.R, variance.G, variance.B,
// variance.Y (of one sample), and the integer channel samples.
void write_exr(const std::filesystem::path& path, const Film& film);

// Reads R, G and B, half or float, and the other channels of write_exr; if one of those is missing,
// all samples and variances are 0. It reads only scanline files with one part.
Film read_exr(const std::filesystem::path& path);

// A picture in linear radiance, by the content of the file, not by its name: EXR, HDR and PFM as
// they are; PNG, JPEG and BMP through decode(), 8 bits per channel, without alpha.
Image read_image(const std::filesystem::path& path);

// Returns whether the file starts like an EXR file.
bool is_exr(const std::filesystem::path& path);

}  // namespace pt
