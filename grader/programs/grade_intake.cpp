#include "grader/programs/grade_intake.h"

#include "grader/base/files.h"
#include "grader/door/clone.h"
#include "grader/service/intake/flatten_boxed.h"
#include "grader/service/intake/read_boxed.h"
#include "grader/service/intake/unpack_boxed.h"

#include <filesystem>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace grader::programs {

// It delegates, so that the destructor removes the copies if this throws.
Intake::Intake(const build::Config& config, const GradeOptions& options)
    : Intake(fmt::format("{}/intake/{}", config.work, getpid())) {
  if (!options.is_named) {
    found_.folder = base::submission_root(options.submission);
    return;
  }
  const bool is_folder = std::filesystem::is_directory(options.submission);
  if (is_folder && door::is_clone(base::submission_root(options.submission))) {
    take_clone(config, options);
    return;
  }
  std::vector<intake::TaskFile> tasks;
  for (const build::TaskConfig& task : config.tasks) tasks.push_back({task.part, task.slug});
  const intake::Unpack unpack = [&](const std::string& archive, const std::string& folder,
                                    intake::Extent extent) {
    return intake::unpack_boxed(config.root, config.work, base::programs_folder(),
                                options.require_isolation)(archive, folder, extent);
  };
  const auto next = [&] {
    std::filesystem::create_directories(work_);
    return std::filesystem::path(next_folder());
  };
  found_ =
      intake::prepare_submission(options.submission, options.submission, {tasks, unpack, next});
  // Somebody who has handed in nothing has attempted nothing.
  if (found_.nothing && is_folder) found_ = {options.submission, "", found_.problem};
  if (found_.problem.empty()) found_.folder = base::submission_root(found_.folder);
}

Intake::~Intake() {
  std::error_code ignored;
  std::filesystem::remove_all(work_, ignored);
}

// A clone of the course's skeleton becomes twelve task files.
void Intake::take_clone(const build::Config& config, const GradeOptions& options) {
  const auto read = [&] {
    const std::string texts = config.root + "/grader/door";
    const door::Clone clone = door::read_clone(base::submission_root(options.submission));
    const door::Generation generation = door::course_of(clone).generation;
    dialect_ = options.dialect == "none" ? door::no_dialect(texts, generation)
                                         : door::load_dialect(texts, generation);
    const std::string folder = next_folder();
    if (!clone.problem.empty()) return intake::Prepared{folder, clone.problem};
    const sandbox::Tier tier =
        intake::tier_for_reading(config.root, config.work, options.require_isolation);
    return intake::Prepared{folder, intake::flatten_boxed(options.submission, clone, config.root,
                                                          base::programs_folder(), tier, folder)};
  };
  found_ = intake::read_handed_in(options.submission, options.submission, read);
}

}  // namespace grader::programs
