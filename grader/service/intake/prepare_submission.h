#pragma once

#include "grader/service/intake/handed_in.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace grader::intake {

// Settings for all submissions of a class.
struct IntakeTools {
  const std::vector<TaskFile>& tasks;
  const Unpack& unpack;
  std::function<std::filesystem::path()> next_folder;  // a path below `work` that is not there yet
};

// A submission as the judge reads it.
struct Prepared {
  std::string folder;   // of the task files; with a problem: the folder that has it
  std::string problem;  // the reason why it cannot be judged, in one sentence; else empty
};

// Returns a submission with this folder and this problem.
HandedIn with(HandedIn by, const Prepared& prepared);

// Looks for the task files in a folder. They may be anywhere in it, packed, or have a name that is
// nearly correct. `name` is the submission's, for messages.
Prepared prepare_submission(const std::string& name, const std::filesystem::path& folder,
                            const IntakeTools& tools);

// The same for an archive.
Prepared prepare_archive(const std::string& name, const std::filesystem::path& archive,
                         const IntakeTools& tools);

// Calls `read`, which reads files in the folder of the submission `name`, and returns its result. A
// file that cannot be read is the submission's problem. Throws pt::Error if the machine is at
// fault.
Prepared read_handed_in(const std::string& name, const std::filesystem::path& folder,
                        const std::function<Prepared()>& read);

}  // namespace grader::intake
