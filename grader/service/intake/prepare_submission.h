#pragma once

#include "grader/door/clone.h"
#include "grader/service/intake/tree.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace grader::intake {

// An archive holds the work of one learner or of the class.
enum class Extent { one, everybody };

// Unpacks an archive to a new folder. Returns why that failed; else an empty text. Throws pt::Error
// if the machine is at fault.
using Unpack = std::function<std::string(const std::string& archive, const std::string& folder,
                                         Extent extent)>;

// Writes the task files of a clone of the course's skeleton, which messages call `name`, to a new
// folder. Returns why that failed; else an empty text. Throws pt::Error if the machine is at fault.
using Flatten = std::function<std::string(const std::string& name, const door::Clone& clone,
                                          const std::string& folder)>;

// The programs that read what was handed in.
struct Readers {
  Unpack unpack;
  Flatten flatten{};  // without it, clones are not noticed
};

// The attempt that counts, of several. The last counts task by task; the first counts alone, as files of a later one are late.
enum class Attempt { last, first };

// Settings for all submissions of a class.
struct IntakeTools {
  const std::vector<TaskFile>& tasks;
  const Readers& readers;
  std::function<std::filesystem::path()> next_folder;  // a path below `work` that is not there yet
  Attempt attempt = Attempt::last;
};

// A submission as the judge reads it.
struct Prepared {
  std::string folder;    // of the task files; with a problem: the folder that has it
  std::string problem;   // the reason why it cannot be judged, in one sentence; else empty
  std::string note{};    // which files count of those that differ, in one sentence; else empty
  bool nothing = false;  // the problem is that it holds no task file
  std::optional<door::Course> course{};  // of a clone: the files are made of it
};

// Looks for the task files in a folder or an archive. They may be anywhere in it, packed, or have a
// name that is nearly correct. If there are none outside of a clone of the course's skeleton, they are
// made of this clone. `name` is the submission's, for messages. A file that cannot be read
// is the submission's problem. Throws pt::Error if the machine is at fault.
Prepared prepare_submission(const std::string& name, const std::filesystem::path& folder_or_archive,
                            const IntakeTools& tools);

// The same for several attempts, the last one last. Of two files for one task the later counts.
Prepared prepare_attempts(const std::string& name,
                          const std::vector<std::filesystem::path>& folders,
                          const IntakeTools& tools);

// Calls `read`, which reads files in the folder of the submission `name`, and returns its result. A
// file that cannot be read is the submission's problem. Throws pt::Error if the machine is at
// fault.
Prepared read_handed_in(const std::string& name, const std::filesystem::path& folder,
                        const std::function<Prepared()>& read);

}  // namespace grader::intake
