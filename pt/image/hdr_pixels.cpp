#include "pt/image/hdr_pixels.h"

#include <cstddef>

namespace pt {

namespace {

// The bytes behind the header, which ends with an empty line and the line of the size.
std::string_view pixels_of(std::string_view hdr) {
  const std::size_t empty = hdr.find("\n\n");
  const std::size_t end = empty == hdr.npos ? hdr.npos : hdr.find('\n', empty + 2);
  return end == hdr.npos ? std::string_view() : hdr.substr(end + 1);
}

int byte(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

// Takes the runs of one channel of a line away. False if they do not fill it exactly.
bool take_channel(std::string_view& bytes, int width) {
  for (int left = width; left > 0;) {
    if (bytes.size() < 2) return false;
    const int count = byte(bytes, 0);
    const bool repeats = count > 128;
    const int pixels = repeats ? count - 128 : count;
    const std::size_t size = 1 + (repeats ? 1 : static_cast<std::size_t>(count));
    if (pixels == 0 || pixels > left || size > bytes.size()) return false;
    bytes.remove_prefix(size);
    left -= pixels;
  }
  return true;
}

}  // namespace

bool has_all_pixels(std::string_view hdr, int width, int height) {
  constexpr int kMinWidth = 8, kMaxWidth = 32767;  // of lines that may have runs
  std::string_view bytes = pixels_of(hdr);
  const bool is_plain =
      bytes.size() / 4 / static_cast<std::size_t>(width) >= static_cast<std::size_t>(height);
  if (width < kMinWidth || width > kMaxWidth) return is_plain;
  for (int y = 0; y < height; ++y) {
    const bool has_runs =
        bytes.size() >= 4 && byte(bytes, 0) == 2 && byte(bytes, 1) == 2 && byte(bytes, 2) < 128;
    if (!has_runs) return y == 0 && is_plain;
    if (byte(bytes, 2) * 256 + byte(bytes, 3) != width) return false;
    bytes.remove_prefix(4);
    for (int channel = 0; channel < 4; ++channel) {
      if (!take_channel(bytes, width)) return false;
    }
  }
  return true;
}

}  // namespace pt
