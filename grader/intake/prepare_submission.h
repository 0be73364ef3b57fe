#pragma once

#include "grader/intake/handed_in.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace grader::intake {

// The same for all submissions of a class.
struct IntakeTools {
  const std::vector<TaskFile>& tasks;
  const Unpack& unpack;
  std::function<std::filesystem::path()> next_folder;  // a path below `work` that is not there yet
};

// Makes by.folder the one where the judge finds all task files, from one in which they may lie anywhere, be packed, or
// be nearly named right; else says the problem.
void prepare_submission(HandedIn& by, const IntakeTools& tools);

// The same of an archive.
void prepare_archive(HandedIn& by, const std::filesystem::path& archive, const IntakeTools& tools);

// Calls `read`, which reads what a learner has handed in: what cannot be read is the submission's problem. Throws pt::Error where
// the machine is at fault.
void note_problem(HandedIn& by, const std::function<void()>& read);

}  // namespace grader::intake
