#pragma once

#include "pt/error.h"
#include "pt/memory.h"
#include "pt/printable.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <string>

// The output at the end of a program.

namespace pt {

// Throws Error if what was printed did not arrive, as on a full disk.
inline void flush_standard_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw Error(std::string("the output cannot be written: ") + std::strerror(errno));
}

// The message of an exception as one line without control characters. File names in it may contain
// them.
inline std::string sentence_of(const std::exception& error) {
  std::string text = error.what();
  if (const auto* files = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
    text = files->path1().string() + ": " + files->code().message();
  }
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    text = "there is not enough memory: " + shown_bytes(memory_left()) +
           " are left for this program; take a smaller scene or picture";
  }
  return printable(text);
}

// The exit status for main: that of `run`, and 2 after one sentence where it throws.
template <class Run>
int run_program(Run run) try {
  const int status = run();
  flush_standard_output();
  return status;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", sentence_of(error).c_str());
  return 2;
}

}  // namespace pt
