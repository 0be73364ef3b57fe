#include "grader/service/intake/file_name.h"

#include "pt/printable.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <clocale>
#include <cstdint>
#include <cwctype>
#include <filesystem>
#include <string_view>

#include <locale.h>

namespace grader::intake {

namespace {

constexpr std::size_t kMaxName = 160;  // bytes

// Two names must not differ by a joiner alone.
bool is_shown(std::int32_t code) {
  const auto within = [&](std::int32_t first, std::int32_t last) {
    return code >= first && code <= last;
  };
  return !(within(0, 0x1f) || within(0x7f, 0x9f) || within(0x200c, 0x200d) ||
           pt::is_invisible(code));
}

// Marks that follow a letter, or the first part of a Korean syllable.
bool is_mark(std::int32_t code) {
  const auto within = [&](std::int32_t first, std::int32_t last) {
    return code >= first && code <= last;
  };
  return within(0x300, 0x36f) || within(0x653, 0x655) || within(0x3099, 0x309a) ||
         within(0x1161, 0x1175) || within(0x11a8, 0x11c2);
}

constexpr std::array kArchives{".zip", ".tar",     ".tar.gz", ".tgz", ".tar.xz",  ".txz",
                               ".7z",  ".tar.bz2", ".tbz2",   ".rar", ".tar.zst", ".tzst"};
// .001, .z01: the first of several parts.
constexpr std::array kOtherPacked{".gz",  ".zst", ".xz",  ".bz2",  ".lz",  ".lzma",
                                  ".z",   ".br",  ".lz4", ".ace",  ".arj", ".lzh",
                                  ".cab", ".dmg", ".iso", ".zipx", ".001", ".z01"};
constexpr std::array kSources{".cpp", ".cpp.txt", ".cc", ".cc.txt", ".cxx", ".c++"};

template <class Endings>
bool has_ending(const std::string& name, const Endings& endings) {
  const std::string small = lower_case(name);
  return std::any_of(endings.begin(), endings.end(),
                     [&](const char* ending) { return small.ends_with(ending); });
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
  const std::string_view before = std::string_view(name).substr(0, name.size() - ending.size());
  return std::string(pt::beginning(before, most - ending.size())) + ending;
}

std::string as_file_name(const std::string& name) {
  std::string clean;
  for (std::size_t at = 0; at < name.size();) {
    const auto [size, code] = pt::first_character(std::string_view(name).substr(at));
    const bool kept = code >= 0 && code != '/' && is_shown(code);
    clean += kept ? name.substr(at, size) : "_";
    at += size;
  }
  clean = cut_name(clean, kMaxName);
  return clean.empty() || clean[0] == '.' ? "_" + clean : clean;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_archive(const std::string& name) { return has_ending(name, kArchives); }

bool is_packed(const std::string& name) {
  return is_archive(name) || has_ending(name, kOtherPacked);
}

bool is_source(const std::string& name) { return has_ending(name, kSources); }

std::string folded(const std::string& name) {
  static const locale_t letters = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  std::string small;
  for (std::size_t at = 0; at < name.size();) {
    const pt::FirstCharacter next = pt::first_character(std::string_view(name).substr(at));
    const auto code = static_cast<std::wint_t>(next.code);
    const std::wint_t lower = letters == nullptr ? std::towlower(code) : towlower_l(code, letters);
    small += next.code < 0 ? name.substr(at, 1) : as_utf8(static_cast<std::uint32_t>(lower));
    at += next.size;
  }
  return small;
}

bool has_marks(const std::string& name) {
  for (std::size_t at = 0; at < name.size();) {
    const pt::FirstCharacter next = pt::first_character(std::string_view(name).substr(at));
    if (is_mark(next.code)) return true;
    at += next.size;
  }
  return false;
}

std::string accents_alike(const std::string& name) {
  std::string plain;
  for (std::size_t at = 0; at < name.size();) {
    const pt::FirstCharacter next = pt::first_character(std::string_view(name).substr(at));
    const bool is_plain = next.code >= 0 && next.code < 0x80;
    if (is_mark(next.code) && !plain.empty()) plain.pop_back();
    plain += is_plain ? static_cast<char>(next.code) : '?';
    at += next.size;
  }
  return plain;
}

}  // namespace grader::intake
