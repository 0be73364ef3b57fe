#include "grader/intake/file_name.h"

#include <algorithm>
#include <clocale>
#include <cstdint>
#include <cwctype>
#include <filesystem>

#include <locale.h>

namespace grader::intake {

namespace {

constexpr std::size_t kMaxName = 160;  // bytes

// A character of a text in UTF-8; 0 bytes where there is not one.
struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;
};

Character character_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t first = byte(at);
  if (first < 0x80) return {first, 1};
  const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  if (first < 0xc2 || first > 0xf4 || at + bytes > text.size()) return {};
  std::uint32_t code = first & (0xffU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(at + i) & 0x3fU);
  }
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  if (code < kLeast[bytes] || code > 0x10ffff || surrogate) return {};
  return {code, bytes};
}

// Control characters, line ends, and what turns the direction of writing or is not seen.
bool is_shown(std::uint32_t code) {
  const auto within = [&](std::uint32_t first, std::uint32_t last) {
    return code >= first && code <= last;
  };
  return !(within(0, 0x1f) || within(0x7f, 0x9f) || code == 0x61c || within(0x200b, 0x200f) ||
           within(0x2028, 0x202e) || within(0x2060, 0x206f) || code == 0xfeff);
}

std::string as_utf8(std::uint32_t code) {
  if (code < 0x80) return {static_cast<char>(code)};
  std::string text;
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  const std::uint32_t marks[] = {0, 0xc0, 0xe0, 0xf0};
  text += static_cast<char>(marks[more] | code >> (6 * more));
  for (int i = more - 1; i >= 0; --i) text += static_cast<char>(0x80 | ((code >> (6 * i)) & 0x3f));
  return text;
}

}  // namespace

std::string beginning(const std::string& text, std::size_t most) {
  std::size_t end = std::min(most, text.size());
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
    --end;
  return text.substr(0, end);
}

std::string ending_of(const std::string& name) {
  constexpr std::size_t kMaxEnding = 12;
  const std::filesystem::path path(name);
  const std::string ending = path.extension(), before = path.stem().extension();
  if (ending.size() > kMaxEnding) return "";
  return before == ".tar" || before == ".cpp" ? before + ending : ending;
}

std::string cut_name(const std::string& name, std::size_t most) {
  if (name.size() <= most) return name;
  const std::string ending = ending_of(name);
  return beginning(name.substr(0, name.size() - ending.size()), most - ending.size()) + ending;
}

std::string as_file_name(const std::string& name) {
  std::string clean;
  for (std::size_t at = 0; at < name.size();) {
    const Character next = character_at(name, at);
    const bool kept = next.bytes > 0 && next.code != '/' && is_shown(next.code);
    clean += kept ? name.substr(at, next.bytes) : "_";
    at += std::max<std::size_t>(next.bytes, 1);
  }
  clean = cut_name(clean, kMaxName);
  return clean.empty() || clean[0] == '.' ? "_" + clean : clean;
}

std::string folded(const std::string& name) {
  static const locale_t letters = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  std::string small;
  for (std::size_t at = 0; at < name.size();) {
    const Character next = character_at(name, at);
    const auto code = static_cast<std::wint_t>(next.code);
    const std::wint_t lower = letters == nullptr ? std::towlower(code) : towlower_l(code, letters);
    small += next.bytes == 0 ? name.substr(at, 1) : as_utf8(static_cast<std::uint32_t>(lower));
    at += std::max<std::size_t>(next.bytes, 1);
  }
  return small;
}

}  // namespace grader::intake
