#include "grader/base/files.h"

#include "grader/base/descriptor.h"
#include "pt/error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#ifndef O_PATH  // not on macOS
#define O_PATH O_RDONLY
#endif

namespace grader::base {

namespace fs = std::filesystem;

std::string programs_folder() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  return program.parent_path().parent_path() / "grader";
}

std::string stamp(const std::string& path) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  const auto written = fs::last_write_time(path, error);
  if (error) {
    throw pt::Error(path +
                    " is missing: ./run grade builds it, and ninja the targets grade, graded");
  }
  return fmt::format("{} {} {}\n", path, size, written.time_since_epoch().count());
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
    return {true, "it is not a regular file", ""};
  }
  if (found.st_nlink > 1) {
    return {true, "the file has a second name (a hard link); hand in a copy", ""};
  }
  const std::string too_large = fmt::format("the file is larger than {} MiB", most >> 20);
  if (found.st_size > static_cast<off_t>(most)) return {true, too_large, ""};
  // The file may still grow.
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

namespace {

// Compilers read UTF-8, and of anything else they name bytes that an editor does not show.
Submitted as_source(Submitted file) {
  const std::string_view text = file.text;
  const bool is_wide = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
                       text.substr(0, 4).find('\0') != text.npos;
  if (is_wide) return {true, "the file is UTF-16 or UTF-32; save it as UTF-8", ""};
  return file;
}

// The file at the end of a path of folders.
Submitted read_along(int top, std::span<const std::string> way, const std::string& name) {
  if (way.empty()) return as_source(read_plain_file(top, name, kMaxFile));
  const Descriptor inner(
      openat(top, way[0].c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (inner.is_open()) return read_along(inner.number(), way.subspan(1), name);
  if (errno == ENOENT) return {};
  return {true, way[0] + " is not a plain folder", ""};
}

[[noreturn]] void refuse_folder(const std::string& folder, const std::error_code& why) {
  if (why == std::errc::no_such_file_or_directory || why == std::errc::not_a_directory) {
    throw pt::Error(folder + " is not a folder; name one with --submission");
  }
  throw pt::Error(folder + ": cannot be read (" + why.message() + "); make the folder readable");
}

// Returns the entries of the folder that are not hidden.
std::vector<fs::directory_entry> shown_in(const std::string& folder) {
  std::vector<fs::directory_entry> inside;
  std::error_code error;
  fs::directory_iterator at(folder, error);
  while (!error && at != fs::directory_iterator()) {
    if (!is_hidden(at->path().filename())) inside.push_back(*at);
    at.increment(error);
  }
  if (error) refuse_folder(folder, error);
  return inside;
}

bool starts_tree(const std::string& name) {
  return name == "student" || (name.size() > 1 && std::isdigit(name[0]) != 0 && name[1] == '_');
}

}  // namespace

std::array<fs::path, 4> places_of(const std::string& part) {
  return {part, fs::path("student") / part, "", "student"};
}

Submitted read_submitted(const std::string& folder, const std::string& part,
                         const std::string& slug) {
  const Descriptor top(open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!top.is_open()) refuse_folder(folder, {errno, std::generic_category()});
  for (const fs::path& place : places_of(part)) {
    const std::vector<std::string> way(place.begin(), place.end());
    Submitted found = read_along(top.number(), way, slug + ".cpp");
    if (found.present) return found;
  }
  return {};
}

bool is_hidden(const std::string& name) { return name.starts_with('.') || name == "__MACOSX"; }

std::string submission_root(const std::string& folder) {
  std::string root = folder;
  for (int depth = 0; depth < 4; ++depth) {
    const std::vector<fs::directory_entry> inside = shown_in(root);
    if (inside.size() != 1) break;
    std::error_code error;
    const bool plain = inside[0].symlink_status(error).type() == fs::file_type::directory;
    if (!plain || starts_tree(inside[0].path().filename())) break;
    root = inside[0].path();
  }
  return root;
}

std::vector<fs::path> sources_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".cpp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace grader::base
