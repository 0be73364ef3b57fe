#include "grader/watch/files.h"

#include <utility>

#include <fmt/format.h>
#include <sys/stat.h>

namespace grader::watch {

namespace {

// A text that changes with each save; empty if there is no file.
std::string stamp_of(const std::string& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return "";
  return fmt::format("{} {} {}.{}", found.st_ino, found.st_size, found.st_mtim.tv_sec,
                     found.st_mtim.tv_nsec);
}

}  // namespace

Files::Files(std::string folder, const std::vector<build::TaskConfig>& tasks)
    : folder_(std::move(folder)), tasks_(tasks) {
  saved();
}

std::vector<std::string> Files::saved() {
  std::vector<std::string> slugs;
  for (const build::TaskConfig& task : tasks_) {
    const std::string now = stamp_of(folder_ + "/" + task.file());
    std::string& before = stamps_[task.slug];
    if (now.empty() || now == before) continue;
    before = now;
    slugs.push_back(task.slug);
  }
  return slugs;
}

}  // namespace grader::watch
