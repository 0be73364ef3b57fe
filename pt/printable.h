#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

// Makes text from outside safe to show: file names and the output of programs may contain anything.

namespace pt {

// The character at the beginning of a text that is not empty: its bytes and its number. One byte is -1 where the
// text is not UTF-8.
struct FirstCharacter {
  std::size_t size = 1;
  std::int32_t code = -1;
};

inline FirstCharacter first_character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return {1, first};
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < size) return {};
  std::int32_t code = first & (0xff >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xc0) != 0x80) return {};
    code = code << 6 | (byte & 0x3f);
  }
  constexpr std::array<std::int32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xd800 && code < 0xe000;
  if (code < kSmallest[size] || is_surrogate || code > 0x10ffff) return {};
  return {size, code};
}

// Returns whether a character is invisible, ends a line, or changes the direction of writing. The joiners
// U+200C and U+200D do not count: Persian names and many emoji need them.
inline bool is_invisible(std::int32_t code) {
  const auto within = [&](std::int32_t first, std::int32_t last) {
    return code >= first && code <= last;
  };
  return code == 0x61c || code == 0x200b || within(0x200e, 0x200f) || within(0x2028, 0x202e) ||
         within(0x2060, 0x206f) || code == 0xfeff || within(0xe0000, 0xe007f);
}

inline constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD

// Valid UTF-8 that no terminal obeys and that misleads no reader. Bytes that are not UTF-8, invisible
// characters, U+FFFE and U+FFFF become U+FFFD. Control characters, also those of 8 bits, become the given
// text. Newlines and tabs may stay.
inline std::string printable(std::string_view text, bool lines = false,
                             std::string_view for_controls = " ") {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const auto [size, code] = first_character(text);
    const bool stays = lines && (code == '\n' || code == '\t');
    const bool is_control = (code >= 0 && code < 0x20) || (code >= 0x7f && code < 0xa0);
    if (is_control && !stays) {
      shown += for_controls;
    } else {
      const bool is_shown = code >= 0 && !is_invisible(code) && code != 0xfffe && code != 0xffff;
      shown += is_shown ? text.substr(0, size) : kReplacement;
    }
    text.remove_prefix(size);
  }
  return shown;
}

// At most `most` bytes from the beginning of a text; no character is cut in two.
inline std::string_view beginning(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  for (int i = 0; i < 3 && end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80; ++i) {
    --end;
  }
  return text.substr(0, end);
}

}  // namespace pt
