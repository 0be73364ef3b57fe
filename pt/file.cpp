#include "pt/file.h"

#include "pt/error.h"

#include <atomic>
#include <cerrno>
#include <fstream>
#include <system_error>

#include <unistd.h>

namespace pt {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const fs::path& path, const std::string& why) {
  throw Error(what + " '" + path.string() + "': " + why);
}

std::string last_error() { return std::generic_category().message(errno); }

void check_place(const fs::path& path) {
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    fail("cannot write", path, "there is no folder '" + folder.string() + "'");
  }
  if (!path.has_filename()) fail("cannot write", path, "the file's name is missing");
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    fail("cannot write", path, "something that is not a file has that name");
  }
}

// A link stays a link: the file that it points to is replaced.
fs::path real_target(const fs::path& path) {
  check_place(path);
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
  fs::path target = fs::weakly_canonical(path, error);
  if (error) fail("cannot write", path, error.message());
  return target;
}

std::ofstream open_beside(const fs::path& path, const fs::path& temporary) {
  errno = 0;
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  if (!out) fail("cannot write", path, last_error());
  return out;
}

}  // namespace

std::string read_file(const fs::path& path, std::size_t max_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) fail("cannot read", path, "there is no such file");
  if (!fs::is_regular_file(status)) fail("cannot read", path, "it is not a file");
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  if (!in) fail("cannot read", path, last_error());
  const auto size = static_cast<std::size_t>(in.tellg());
  if (size > max_bytes) {
    fail("cannot read", path,
         "it has " + std::to_string(size) + " bytes, more than the " + std::to_string(max_bytes) +
             " that are accepted");
  }
  std::string bytes(size, '\0');
  in.seekg(0);
  if (!in.read(bytes.data(), static_cast<std::streamsize>(size))) {
    fail("cannot read", path, last_error());
  }
  return bytes;
}

std::string temporary_name(const fs::path& path) {
  static std::atomic<int> serial{0};
  return path.string() + '.' + std::to_string(getpid()) + '.' + std::to_string(++serial) + ".tmp";
}

void check_target(const fs::path& path) {
  const fs::path temporary = temporary_name(real_target(path));
  open_beside(path, temporary);
  std::error_code error;
  fs::remove(temporary, error);
}

void write_file(const fs::path& path, std::string_view bytes) {
  const fs::path target = real_target(path);
  const fs::path temporary = temporary_name(target);
  std::ofstream out = open_beside(path, temporary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code error;
  std::string why = out ? "" : last_error();
  if (why.empty()) {
    fs::rename(temporary, target, error);
    if (!error) return;
    why = error.message();
  }
  fs::remove(temporary, error);
  fail("cannot write", path, why);
}

}  // namespace pt
