#include "grader/judge/files.h"

#include "grader/process/descriptor.h"
#include "pt/error.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

namespace grader {

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw pt::Error(path + ": cannot be read");
  return text.str();
}

std::string temporary_name(const std::string& path) {
  static std::atomic<int> serial{0};
  return fmt::format("{}.{}.{}", path, getpid(), ++serial);
}

void write_file(const std::string& path, std::string_view text) {
  const std::string temporary = temporary_name(path);
  std::ofstream file(temporary, std::ios::binary);
  file << text;
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(temporary, path, error);
  if (!file || error) throw pt::Error(path + ": cannot be written");
}

std::string stamp(const std::string& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0)
    throw pt::Error(path + " is missing: build the target grade");
  return fmt::format("{} {} {}.{}\n", path, found.st_size, found.st_mtim.tv_sec,
                     found.st_mtim.tv_nsec);
}

Submitted read_plain_file(int folder, const std::string& name, std::size_t most) {
  // Without O_NONBLOCK, opening a named pipe would wait for a writer.
  const Descriptor file(
      openat(folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!file.is_open()) {
    if (errno == ENOENT) return {};
    return {true, "the file is a link, or cannot be read", ""};
  }
  struct stat found {};
  if (fstat(file.number(), &found) != 0 || !S_ISREG(found.st_mode)) {
    return {true, "the file is no regular file", ""};
  }
  const std::string too_large = fmt::format("the file is larger than {} MiB", most >> 20);
  if (found.st_size > static_cast<off_t>(most)) return {true, too_large, ""};
  // It may still grow.
  std::string text(static_cast<std::size_t>(found.st_size) + 1, '\0');
  std::size_t size = 0;
  for (ssize_t got = 1; got > 0; size += static_cast<std::size_t>(got)) {
    if (size == text.size()) text.resize(std::min(most + 1, 2 * size));
    if (size == text.size()) return {true, too_large, ""};
    got = read(file.number(), text.data() + size, text.size() - size);
    if (got < 0) return {true, "the file cannot be read", ""};
  }
  text.resize(size);
  return {true, "", text};
}

Submitted read_submitted(const std::string& folder, const std::string& part,
                         const std::string& slug) {
  const Descriptor top(open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!top.is_open()) throw pt::Error(folder + " is no folder; name one with --submission");
  const Descriptor inner(
      openat(top.number(), part.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!inner.is_open()) {
    if (errno == ENOENT) return {};
    return {true, part + " is no plain folder", ""};
  }
  return read_plain_file(inner.number(), slug + ".cpp", kMaxFile);
}

}  // namespace grader
