#include "grader/service/process/memory_group.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace grader::process {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kName = "firstlight.";

// The files of a group exist already, so this never creates one.
bool write_to(const char* path, std::string_view text) {
  const int file = open(path, O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool written = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  close(file);
  return written;
}

// The folder where the tree of version 2 is mounted: "... / /sys/fs/cgroup rw - cgroup2 cgroup2 rw".
std::string mount_point(const std::string& mounts) {
  std::istringstream lines(mounts);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" - cgroup2 ") == line.npos) continue;
    std::istringstream words(line);
    std::string skipped, place;
    for (int i = 0; i < 4; ++i) words >> skipped;
    if (words >> place) return place;
  }
  return "";
}

// This process's group in that tree: the line "0::/path".
std::string own_group(const std::string& groups) {
  std::istringstream lines(groups);
  for (std::string line; std::getline(lines, line);) {
    // "/../x": outside the part of the tree that this process sees.
    if (line.starts_with("0::/")) return line.starts_with("0::/..") ? "" : line.substr(3);
  }
  return "";
}

bool takes_groups(const fs::path& place) {
  std::ifstream file(place / "cgroup.subtree_control");
  bool bounds_memory = false;
  for (std::string word; file >> word;) bounds_memory = bounds_memory || word == "memory";
  return bounds_memory && access(place.c_str(), W_OK) == 0 &&
         access((place / "cgroup.procs").c_str(), W_OK) == 0;
}

// firstlight.<process>.<serial>
bool is_of_a_dead_process(const std::string& name) {
  if (!name.starts_with(kName)) return false;
  pid_t pid = 0;
  const std::string_view rest = std::string_view(name).substr(kName.size());
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), pid);
  return error == std::errc() && end != rest.data() + rest.size() && *end == '.' && pid > 0 &&
         kill(pid, 0) != 0 && errno == ESRCH;
}

}  // namespace

std::string place_for_groups(const std::string& mounts, const std::string& groups) {
  const std::string mounted = mount_point(mounts), own = own_group(groups);
  if (mounted.empty() || own.empty()) return "";
  const fs::path here = own == "/" ? fs::path(mounted) : fs::path(mounted + own);
  if (takes_groups(here)) return here;
  return own != "/" && takes_groups(here.parent_path()) ? here.parent_path() : "";
}

MemoryGroups::MemoryGroups(std::string place) : place_(std::move(place)) {
  if (place_.empty()) return;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(place_, ignored)) {
    if (is_of_a_dead_process(entry.path().filename())) rmdir(entry.path().c_str());
  }
}

// A killed process takes a moment to disappear. The next judge removes the groups that are left.
MemoryGroups::~MemoryGroups() {
  for (int i = 0; i < 20 && !made_.empty(); ++i) {
    remove_empty();
    if (!made_.empty()) usleep(1000);
  }
}

// The kernel does not remove a group that has processes.
void MemoryGroups::remove_empty() {
  std::erase_if(
      made_, [](const std::string& group) { return rmdir(group.c_str()) == 0 || errno == ENOENT; });
}

std::string MemoryGroups::make(std::uint64_t bytes) {
  if (place_.empty()) return "";
  remove_empty();
  std::string group = fmt::format("{}/{}{}.{}", place_, kName, getpid(), ++serial_);
  if (mkdir(group.c_str(), 0700) != 0) return "";
  if (!write_to((group + "/memory.max").c_str(), std::to_string(bytes))) {
    rmdir(group.c_str());
    return "";
  }
  // These files are missing without swap, or on older kernels.
  write_to((group + "/memory.swap.max").c_str(), "0");
  write_to((group + "/memory.oom.group").c_str(), "1");
  made_.push_back(group);
  return group;
}

bool join_group(const char* group, pid_t pid) {
  char path[4096], number[16];
  const int length = std::snprintf(path, sizeof path, "%s/cgroup.procs", group);
  const int digits = std::snprintf(number, sizeof number, "%d", static_cast<int>(pid));
  return length > 0 && length < static_cast<int>(sizeof path) &&
         write_to(path, {number, static_cast<std::size_t>(digits)});
}

}  // namespace grader::process
