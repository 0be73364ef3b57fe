#include "grader/judge/staging.h"

#include "grader/base/descriptor.h"
#include "grader/judge/cache.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>

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

// Whatever the umask: another user reads it.
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

// The path and all that it includes, and what that includes.
void add_reached(const std::string& path, const Headers& all, std::set<std::string>& reached) {
  const auto found = all.find(path);
  if (found == all.end() || !reached.insert(path).second) return;
  std::istringstream lines(found->second);
  constexpr std::string_view kInclude = "#include \"";
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(kInclude, 0) != 0) continue;
    add_reached(line.substr(kInclude.size(), line.rfind('"') - kInclude.size()), all, reached);
  }
}

// Returns whether a header is part of what tasks are made of; all others belong to the renderer.
bool is_common(const std::string& path) {
  for (const char* folder : {"pt/math/", "pt/geometry/", "pt/sampling/", "pt/tasks/"}) {
    if (path.rfind(folder, 0) == 0) return true;
  }
  for (const char* file : {"pt/error.h", "pt/todo.h", "pt/scene/camera.h", "pt/scene/light.h",
                           "pt/scene/material.h", "pt/scene/field_of_view.h"}) {
    if (path == file) return true;
  }
  return false;
}

bool has_nothing_of_the_renderer(const std::string& path, const Headers& all) {
  const std::set<std::string> reached = reached_from(path, all);
  return std::all_of(reached.begin(), reached.end(), is_common);
}

void make_folder(const fs::path& path) {
  std::error_code error;
  const bool is_new = fs::create_directories(path, error);
  if (!error && is_new) fs::permissions(path, fs::perms(0755), error);
  if (error) throw pt::Error(path.string() + ": cannot be made (" + error.message() + ")");
}

}  // namespace

std::set<std::string> reached_from(const std::string& path, const Headers& all) {
  std::set<std::string> reached;
  add_reached(path, all, reached);
  return reached;
}

Headers public_headers(const std::string& root) {
  Headers headers;
  for (const auto& entry : fs::recursive_directory_iterator(root + "/pt")) {
    if (entry.path().extension() != ".h") continue;
    headers[fs::relative(entry.path(), root)] = base::read_file(entry.path());
  }
  return headers;
}

std::string code_of(const std::string& header) {
  for (const char* word : {"assert", "__LINE__", "R\"", "\\\n"}) {
    if (header.find(word) != header.npos) return header;
  }
  std::string code;
  for (std::size_t i = 0; i < header.size();) {
    const char c = header[i];
    std::size_t end = i + 1;
    if (header.compare(i, 2, "//") == 0) {
      i = std::min(header.find('\n', i), header.size());
      continue;
    }
    if (header.compare(i, 2, "/*") == 0) {
      const std::size_t close = header.find("*/", i + 2);
      i = close == header.npos ? header.size() : close + 2;
      code += ' ';
      continue;
    }
    if (c == '"' || c == '\'') {
      while (end < header.size() && header[end] != c) end += header[end] == '\\' ? 2 : 1;
      end = std::min(end + 1, header.size());
    }
    if (c != '\n' || (!code.empty() && code.back() != '\n')) code.append(header, i, end - i);
    i = end;
  }
  return code;
}

Headers headers_for(const Task& task, const Headers& all) {
  std::set<std::string> known = reached_from("pt/tasks/" + task.slug + ".h", all);
  for (const auto& [path, text] : all) {
    const std::string name = "pt::" + std::filesystem::path(path).stem().string();
    const bool called = may_call(task, name);
    if (called || has_nothing_of_the_renderer(path, all)) add_reached(path, all, known);
  }
  Headers headers;
  for (const auto& [path, text] : all) {
    headers[path] =
        known.contains(path)
            ? text
            : fmt::format("#error \"{} may not include {}: it does not need that header\"\n",
                          task.slug, path);
  }
  return headers;
}

Stage::Stage(const std::string& folder) : folder_(folder) { make_folder(folder); }

void Stage::put(const std::string& file, const std::string& text) const {
  const fs::path path = fs::path(folder_) / file;
  make_folder(path.parent_path());
  put_file(path, text);
}

void Stage::copy(const std::string& file, const std::string& from) const {
  const fs::path path = fs::path(folder_) / file;
  std::error_code error;
  fs::copy_file(from, path, error);
  if (!error) fs::permissions(path, fs::perms(0644), error);
  if (error) {
    throw pt::Error(fmt::format("{}: cannot be copied to {} ({})", from, folder_, error.message()));
  }
}

// A compiler that was killed may take a moment to be gone.
Stage::~Stage() {
  std::error_code error;
  fs::remove_all(folder_, error);
  for (int i = 0; i < 100 && error; ++i) {
    poll(nullptr, 0, 10);
    fs::remove_all(folder_, error);
  }
}

base::Submitted Stage::take(const std::string& name, std::size_t most) const {
  const base::Descriptor place(
      open(folder_.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  return base::read_plain_file(place.number(), name, most);
}

std::string kept_folder(const std::string& work, const std::string& key,
                        const std::function<void(const Stage&)>& fill) {
  const std::string folder = work + "/kept/" + key;
  if (!fs::exists(folder)) {
    make_folder(work + "/kept");
    // In the cache the next run removes what a killed one leaves.
    const Stage stage(pt::temporary_name(work + "/cache/kept.tree"));
    fill(stage);
    std::error_code error;
    fs::rename(stage.folder(), folder, error);  // or another judge has made it meanwhile
    if (!fs::exists(folder)) {
      throw pt::Error(folder + ": cannot be made (" + error.message() + ")");
    }
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
