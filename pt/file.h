#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

// Whole files, read and written at once.

namespace pt {

// The file's bytes. Throws pt::Error if it is missing, not a regular file, unreadable, or longer
// than `max_bytes`.
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes = SIZE_MAX);

// Throws pt::Error if write_file(path) could not work: no such folder, `path` is itself a folder or a
// device, or no file can be made beside it, which is tried. Call it before the work whose result
// will be written.
void check_target(const std::filesystem::path& path);

// A name next to `path` that no other thread and no other process uses:
// <path>.<process>.<serial>.tmp.
std::string temporary_name(const std::filesystem::path& path);

// Makes `bytes` the content of the file at `path`, whole or not at all: they go to a file with a
// temporary name, which is then renamed. If this fails (pt::Error), an older file at `path` is
// unchanged, and no temporary file remains. If several threads write the same file, it has the
// bytes of one of them.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace pt
