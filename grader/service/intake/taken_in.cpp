#include "grader/service/intake/taken_in.h"

#include "grader/base/files.h"
#include "grader/service/intake/boxed_readers.h"
#include "pt/error.h"

#include <atomic>
#include <filesystem>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace grader::intake {

namespace {

// Of the copies of this process.
std::string next_number() {
  static std::atomic<int> made = 0;
  return fmt::format("{}.{}", getpid(), ++made);
}

}  // namespace

// It delegates, so that the destructor removes the copies if this throws.
TakenIn::TakenIn(const build::Config& config, const std::string& submission)
    : TakenIn(config.work + "/intake/" + next_number()) {
  std::vector<TaskFile> tasks;
  for (const build::TaskConfig& task : config.tasks) tasks.push_back({task.part, task.slug});
  const Readers readers = boxed_readers(config.root, config.work, base::programs_folder(), false);
  const auto next = [&] {
    std::filesystem::create_directories(work_);
    return std::filesystem::path(work_) / std::to_string(++folders_);
  };
  found_ = prepare_submission(submission, submission, {tasks, readers, next});
  // Somebody who has handed in nothing has attempted nothing.
  if (found_.nothing && std::filesystem::is_directory(submission))
    found_ = {submission, "", found_.problem};
  if (found_.problem.empty()) found_.folder = base::submission_root(found_.folder);
}

TakenIn::~TakenIn() {
  std::error_code ignored;
  std::filesystem::remove_all(work_, ignored);
}

const std::string& TakenIn::folder() const {
  if (!found_.problem.empty()) throw pt::Error(found_.problem);
  return found_.folder;
}

}  // namespace grader::intake
