#include "grader/service/build/tool_folder.h"

#include "grader/base/descriptor.h"
#include "grader/service/build/cache.h"
#include "pt/error.h"
#include "pt/file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace grader::build {

namespace fs = std::filesystem;

namespace {

// A compiler may write this many bytes, and this many must be free on the disk.
constexpr off_t kRoomToWrite = off_t{16} << 20;
constexpr std::uintmax_t kRoomToHave = std::uintmax_t{64} << 20;

// Another user reads the file, so the umask does not count.
void put_file(const fs::path& path, const std::string& text) {
  errno = 0;
  const base::Descriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  const bool whole =
      file.is_open() && fchmod(file.number(), 0644) == 0 &&
      write(file.number(), text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (!whole) {
    throw pt::Error(fmt::format("{}: cannot be written ({})", path.string(),
                                errno == 0 ? "the disk is full" : std::strerror(errno)));
  }
}

void make_folder(const fs::path& path) {
  std::error_code error;
  const bool is_new = fs::create_directories(path, error);
  if (!error && is_new) fs::permissions(path, fs::perms(0755), error);
  if (error) throw pt::Error(path.string() + ": cannot be made (" + error.message() + ")");
}

}  // namespace

ToolFolder::ToolFolder(const std::string& folder) : folder_(folder) { make_folder(folder); }

void ToolFolder::put(const std::string& file, const std::string& text) const {
  const fs::path path = fs::path(folder_) / file;
  make_folder(path.parent_path());
  put_file(path, text);
}

void ToolFolder::copy(const std::string& file, const std::string& from) const {
  const fs::path path = fs::path(folder_) / file;
  std::error_code error;
  fs::copy_file(from, path, error);
  if (!error) fs::permissions(path, fs::perms(0644), error);
  if (error) {
    throw pt::Error(fmt::format("{}: cannot be copied to {} ({})", from, folder_, error.message()));
  }
}

// A killed compiler may take a moment to disappear.
ToolFolder::~ToolFolder() {
  std::error_code error;
  fs::remove_all(folder_, error);
  for (int i = 0; i < 100 && error; ++i) {
    poll(nullptr, 0, 10);
    fs::remove_all(folder_, error);
  }
}

base::Submitted ToolFolder::take(const std::string& name, std::size_t most) const {
  const base::Descriptor place(
      open(folder_.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  return base::read_plain_file(place.number(), name, most);
}

std::string kept_folder(const std::string& work, const std::string& key,
                        const std::function<void(const ToolFolder&)>& fill) {
  std::string folder = work + "/kept/" + key;
  mark_used(folder);  // so that no other judge removes it
  if (!fs::exists(folder)) {
    make_folder(work + "/kept");
    // The folder is in the cache: the next run removes what a killed run leaves.
    const ToolFolder tree(pt::temporary_name(work + "/cache/kept.tree"));
    fill(tree);
    std::error_code error;
    fs::rename(tree.folder(), folder, error);
    // Another judge may have made the folder meanwhile.
    if (!fs::exists(folder)) {
      throw pt::Error(folder + ": cannot be made (" + error.message() + ")");
    }
    remove_unused_beside(folder);
  }
  return folder;
}

std::string lack_of_room(const std::string& folder) {
  struct statvfs disk {};
  if (statvfs(folder.c_str(), &disk) != 0) return std::strerror(errno);
  const std::uintmax_t left = std::uintmax_t{disk.f_bavail} * disk.f_frsize;
  if (left < kRoomToHave) return fmt::format("the disk has {} MiB left", left >> 20);
  if (disk.f_files > 0 && disk.f_favail == 0) return "the disk can hold no more files";
  const std::string path = pt::temporary_name(folder + "/room");
  const base::Descriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (!file.is_open()) return std::strerror(errno);
  const int problem = posix_fallocate(file.number(), 0, kRoomToWrite);
  unlink(path.c_str());
  return problem == 0 ? "" : std::strerror(problem);
}

}  // namespace grader::build
