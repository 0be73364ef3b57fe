#pragma once

#include "pt/end_of_program.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

// Functions that the fuzz targets share. A target is one function, libFuzzer's
// LLVMFuzzerTestOneInput (llvm.org/docs/LibFuzzer.html): it accepts any bytes and returns. If it
// finds a fault, it aborts.

namespace fuzz {

inline std::string_view as_text(const std::uint8_t* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

// The input as a file, for functions that read files. The file is removed when the program ends.
inline std::filesystem::path as_file(std::string_view bytes) {
  struct File {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("fuzz." + std::to_string(getpid()));
    ~File() { std::filesystem::remove(path); }
  };
  static const File file;
  std::ofstream(file.path, std::ios::binary) << bytes;
  return file.path;
}

inline void expect(bool holds) {
  if (!holds) abort();
}

// An input is refused by an exception that pt::sentence_of can describe.
inline void expect_reason(const std::exception& error) { expect(!pt::sentence_of(error).empty()); }

// Printed text contains nothing that moves a terminal's cursor.
inline void expect_sentence(std::string_view text) {
  expect(!text.empty());
  for (const char c : text) expect(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
}

}  // namespace fuzz
