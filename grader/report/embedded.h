#pragma once

#include "pt/image/film.h"
#include "pt/image/picture.h"
#include "pt/image/sample_map.h"

#include <cstdint>
#include <string>
#include <string_view>

// Data inside a page, because a page fetches nothing.

namespace grader::report {

// RFC 4648, with padding.
std::string base64(std::string_view bytes);

// "data:image/png;base64,...": an address for an image.
std::string png_address(const pt::Picture& picture);

// The bits of the nearest IEEE 754 half; values beyond its range become infinite.
std::uint16_t to_half(double value);

// Halves, little-endian, in base64: r, g and b of every pixel, row by row, the top row first.
std::string embedded_pixels(const pt::Film& film);

// The same for one value per pixel: the standard deviation of the difference of the luminances.
// Empty if a film does not have the variances. The films have the same size.
std::string embedded_noise(const pt::Film& render, const pt::Film& golden);

// The counts as 32-bit integers, little-endian, in base64.
std::string embedded_counts(const pt::SampleMap& map);

}  // namespace grader::report
