#include "grader/watch/files.h"

#include "grader/base/files.h"
#include "grader/door/clone.h"
#include "grader/door/flatten.h"
#include "grader/service/intake/taken_in.h"
#include "pt/file.h"

#include <filesystem>
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

Files::Files(std::string folder, const build::Config& config)
    : folder_(std::move(folder)), config_(config) {
  const std::string root = base::submission_root(folder_);
  if (door::is_clone(root)) folder_ = root;
  saved();
}

std::vector<std::string> Files::saved() {
  if (door::is_clone(folder_)) return saved_in_clone();
  std::vector<std::string> slugs;
  for (const build::TaskConfig& task : config_.tasks) {
    for (const std::string& name : {task.slug, task.slug + kExamples}) {
      const std::string now = stamp_of(fmt::format("{}/{}/{}.cpp", folder_, task.part, name));
      std::string& before = stamps_[name];
      if (now.empty() || now == before) continue;
      before = now;
      slugs.push_back(name);
    }
  }
  return slugs;
}

std::vector<std::string> Files::saved_in_clone() {
  std::map<std::string, std::string> stamps;
  for (const std::string& file : door::paths_in(folder_)) stamps[file] = stamp_of(file);
  if (stamps == stamps_) return {};
  stamps_ = std::move(stamps);
  std::map<std::string, Made> now = made();
  std::vector<std::string> own, all;
  for (const build::TaskConfig& task : config_.tasks) {
    const Made &before = made_[task.slug], &after = now[task.slug];
    if (before.functions != after.functions) own.push_back(task.slug);
    if (before != after) all.push_back(task.slug);
  }
  made_ = std::move(now);
  return own.empty() ? all : own;
}

// If the clone cannot be read, all texts are empty, and `grade` says why.
std::map<std::string, Files::Made> Files::made() const {
  std::map<std::string, Made> all;
  const intake::TakenIn taken(config_, folder_);
  if (!taken.found().problem.empty()) return all;
  for (const build::TaskConfig& task : config_.tasks) {
    const std::string file = taken.found().folder + "/" + task.file();
    if (std::filesystem::exists(file))
      all[task.slug] = {pt::read_file(file), pt::read_file(file + door::kFunctions)};
  }
  return all;
}

}  // namespace grader::watch
