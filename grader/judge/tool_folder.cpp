#include "grader/judge/tool_folder.h"

#include "grader/base/descriptor.h"
#include "grader/judge/cache.h"
#include "grader/judge/kept.h"
#include "pt/error.h"
#include "pt/file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace grader::judge {

namespace fs = std::filesystem;

namespace {

// A compiler may write so many bytes, and so many have to be left on the disk.
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

// Returns whether the folder is there with all its files, which one look per process tells. From then on it
// stays.
bool is_known_whole(const std::string& folder) {
  static std::mutex mutex;
  static std::set<std::string> known;
  const std::lock_guard lock(mutex);
  const bool is_there = use_folder(folder);
  if (is_there && known.contains(folder)) return true;
  known.erase(folder);
  if (!is_there || !is_whole_folder(folder)) return false;
  known.insert(folder);
  return true;
}

// Makes the files of the folder those of the tree, one by one: compilers may be reading there.
void repair(const fs::path& folder, const fs::path& tree) {
  for (const auto& entry : fs::recursive_directory_iterator(tree)) {
    const fs::path to = folder / entry.path().lexically_relative(tree);
    if (entry.is_directory()) {
      make_folder(to);
      continue;
    }
    std::error_code error;
    fs::rename(entry.path(), to, error);
    if (error) throw pt::Error(to.string() + ": cannot be made (" + error.message() + ")");
  }
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

// A compiler that was killed may take a moment to be gone.
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
  if (!is_known_whole(folder)) {
    make_folder(work + "/kept");
    // It is in the cache, where the next run removes what a killed one leaves.
    const ToolFolder tree(pt::temporary_name(work + "/cache/kept.tree"));
    fill(tree);
    note_sums(tree.folder());
    std::error_code error;
    fs::rename(tree.folder(), folder, error);
    if (error)
      repair(folder, tree.folder());  // it is damaged, or another judge has made it meanwhile
    if (!is_known_whole(folder)) throw pt::Error(folder + ": cannot be made");
    remove_unused_beside(folder);
  }
  mark_used(folder);
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

}  // namespace grader::judge
