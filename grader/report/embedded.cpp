#include "grader/report/embedded.h"

#include "pt/image/image_io.h"

#include <cmath>

namespace grader::report {

namespace {

// `count` bytes of `value`, the lowest first.
void append(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

std::string png_address(const pt::Picture& picture) {
  return "data:image/png;base64," + base64(pt::encode_png(picture));
}

std::uint16_t to_half(double value) {
  const std::uint32_t sign = std::signbit(value) ? 0x8000 : 0;
  const double size = std::abs(value);
  if (std::isnan(value)) return static_cast<std::uint16_t>(sign | 0x7e00);
  if (size >= 65520) return static_cast<std::uint16_t>(sign | 0x7c00);
  // In units of the last place; a fraction that is rounded up to the next power of two carries into
  // the exponent by itself.
  const int exponent = size < 0x1p-14 ? -14 : std::ilogb(size);
  const double fraction = std::nearbyint(std::ldexp(size, 10 - exponent));
  const std::uint32_t bits =
      (static_cast<std::uint32_t>(exponent + 14) << 10) + static_cast<std::uint32_t>(fraction);
  return static_cast<std::uint16_t>(sign | bits);
}

std::string embedded_pixels(const pt::Film& film) {
  std::string bytes;
  for (const pt::FilmPixel& pixel : film.pixels) {
    for (int c = 0; c < 3; ++c) append(bytes, to_half(pixel.mean[c]), 2);
  }
  return base64(bytes);
}

std::string embedded_noise(const pt::Film& render, const pt::Film& golden) {
  std::string bytes;
  for (std::size_t i = 0; i < render.pixels.size(); ++i) {
    const pt::FilmPixel &a = render.pixels[i], &b = golden.pixels[i];
    if (a.samples < 2 || b.samples < 2) return "";
    append(bytes, to_half(std::sqrt(a.variance_y / a.samples + b.variance_y / b.samples)), 2);
  }
  return base64(bytes);
}

std::string embedded_counts(const pt::SampleMap& map) {
  std::string bytes;
  for (const int count : map.counts) append(bytes, static_cast<std::uint32_t>(count), 4);
  return base64(bytes);
}

}  // namespace grader::report
