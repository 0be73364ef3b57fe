#include "pt/image/pfm.h"

#include "pt/error.h"
#include "pt/number.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace pt {
namespace {

// Takes the next word off the front, and the one space after it.
std::string_view take_word(std::string_view& bytes) {
  const std::size_t end = std::min(bytes.find_first_of(" \t\r\n"), bytes.size());
  const std::string_view word = bytes.substr(0, end);
  bytes.remove_prefix(std::min(end + 1, bytes.size()));
  return word;
}

template <class Number>
Number number(std::string_view word) {
  return number_in<Number>(word).value_or(Number{});
}

float float_at(const char* bytes, bool little) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[little ? 3 - i : i]);
    bits = bits << 8 | byte;
  }
  return std::bit_cast<float>(bits);
}

}  // namespace

bool starts_as_pfm(std::string_view bytes) {
  return bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == 'F' || bytes[1] == 'f');
}

Image decode_pfm(std::string_view bytes, const std::string& name) {
  const auto refuse = [&](const std::string& why) {
    throw Error("cannot read '" + name + "': " + why);
  };
  const std::size_t channels = take_word(bytes) == "PF" ? 3 : 1;
  const int width = number<int>(take_word(bytes)), height = number<int>(take_word(bytes));
  const double scale = number<double>(take_word(bytes));
  if (!is_image_size(width, height) || scale == 0) {
    refuse("a PFM picture begins with PF, its width, its height and a scale that is not 0");
  }
  Image image(width, height);
  if (bytes.size() < image.pixels.size() * channels * 4) refuse("it ends before its last pixel");
  const char* at = bytes.data();
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      Rgb& pixel = image.at(x, y);
      pixel.r = float_at(at, scale < 0);
      pixel.g = channels == 3 ? float_at(at + 4, scale < 0) : pixel.r;
      pixel.b = channels == 3 ? float_at(at + 8, scale < 0) : pixel.r;
      at += 4 * channels;
    }
  }
  return image;
}

}  // namespace pt
