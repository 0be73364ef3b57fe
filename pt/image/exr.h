#pragma once

#include "pt/image/film.h"

#include <cstddef>
#include <string>
#include <string_view>

// A film as the bytes of an EXR file and back; image_io.h says which channels.

namespace pt {

// No picture of an accepted size needs more, whatever else its file holds.
inline constexpr std::size_t kMaxPictureBytes = (std::size_t{1} << 31) - 1;

bool starts_as_exr(std::string_view bytes);

// `settings`, if any, is kept in the header as the attribute "firstlight": one line on how it was made.
std::string encode_exr(const Film& film, const std::string& settings = "");

// The settings of an EXR file; empty if it has none.
std::string exr_settings(const std::string& bytes, const std::string& name);

// Throws pt::Error, with `name`, if the bytes are not a picture that can be used.
Film decode_exr(const std::string& bytes, const std::string& name);

}  // namespace pt
