#pragma once

#include "pt/error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>

// The last words of a program.

namespace pt {

// To be called at the end of main: throws Error if what was printed did not arrive, as on a full
// disk.
inline void flush_standard_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw Error(std::string("the output cannot be written: ") + std::strerror(errno));
}

// Control characters, which a terminal obeys, become spaces: those of ASCII, and U+0080 to U+009F, which
// are C2 and a byte of 80 to 9F in UTF-8.
inline std::string without_controls(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (byte < 0x20 || byte == 0x7f) text[i] = ' ';
    if (byte == 0xc2 && next >= 0x80 && next < 0xa0) text[i] = text[i + 1] = ' ';
  }
  return text;
}

// The text of an exception, in one line that a terminal does not obey: names of files may hold
// anything.
inline std::string sentence_of(const std::exception& error) {
  std::string text = error.what();
  if (const auto* files = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
    text = files->path1().string() + ": " + files->code().message();
  }
  return without_controls(std::move(text));
}

}  // namespace pt
