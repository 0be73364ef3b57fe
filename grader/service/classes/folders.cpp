#include "grader/service/classes/folders.h"

#include "grader/base/files.h"
#include "grader/service/classes/identity.h"
#include "grader/service/intake/tree.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <vector>

namespace grader::classes {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kKeptUnpacked = 2;
constexpr const char* kTaskFiles = "task files";

}  // namespace

std::string folder_to_unpack(const std::string& out) {
  const fs::path folder = out + "/unpacked";
  std::vector<fs::path> former;
  if (fs::is_directory(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) former.push_back(entry.path());
  }
  std::ranges::sort(former, std::ranges::greater{},
                    [](const fs::path& path) { return fs::last_write_time(path); });
  for (std::size_t i = kKeptUnpacked - 1; i < former.size(); ++i) fs::remove_all(former[i]);
  return folder / random_text();
}

void keep_task_files(const build::Config& config, ClassPlan& plan, const std::string& unpacked) {
  if (!fs::is_directory(unpacked)) return;
  const fs::path kept = fs::path(unpacked) / kTaskFiles;
  for (std::size_t i = 0; i < plan.everybody.size(); ++i) {
    intake::HandedIn& by = plan.everybody[i];
    if (!by.problem.empty() || !intake::lies_in(by.folder, unpacked)) continue;
    const fs::path root = base::submission_root(by.folder), to = kept / std::to_string(i);
    fs::create_directories(to);
    for (const build::TaskConfig& task : config.tasks) {
      for (const fs::path& place : base::places_of(task.part)) {
        const fs::path way = place / (task.slug + ".cpp");
        if (!fs::exists(fs::symlink_status(root / way))) continue;
        fs::create_directories((to / way).parent_path());
        fs::rename(root / way, to / way);
      }
    }
    by.folder = to;
  }
  std::vector<fs::path> rest;
  for (const auto& entry : fs::directory_iterator(unpacked)) {
    if (entry.path() != kept) rest.push_back(entry.path());
  }
  for (const fs::path& path : rest) fs::remove_all(path);
}

void hide_folders(ClassPlan& plan, const std::string& unpacked) {
  const fs::path links = fs::path(unpacked) / "links";
  fs::create_directories(links);
  for (intake::HandedIn& by : plan.everybody) {
    if (by.folder.empty()) continue;
    fs::create_directory_symlink(by.folder, links / by.name);
    by.folder = links / by.name;
  }
}

}  // namespace grader::classes
