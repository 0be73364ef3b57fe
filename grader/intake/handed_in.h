#pragma once

#include "grader/intake/owner.h"
#include "grader/intake/tree.h"
#include "grader/intake/unpack.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace grader::intake {

// The submission of one learner or of one group.
struct HandedIn {
  // The name of the learner or of the folder, as the name of a file: at most 200 bytes, without control characters, unlike all
  // others even where large and small letters are the same.
  std::string name;
  std::string id;       // that the learning platform has for it; may be empty
  std::string folder;   // of the files, in `work` or the place where they lay
  bool late = false;    // the platform says so
  std::string problem;  // the reason why it cannot be judged, in one sentence; else empty
  Platform platform = Platform::none;
  std::string feedback{};  // the path under which the platform takes a page back; empty: none
};

// Unpacks an archive to a folder that is not there yet. Returns why it could not; else empty. Throws
// pt::Error where the machine is at fault.
using Unpack = std::function<std::string(const std::string& archive, const std::string& folder,
                                         Extent extent)>;

// Called when the number of submissions is known, and after each that has been taken in.
using Progress = std::function<void(std::size_t done, std::size_t all)>;

struct HandedInByAll {
  std::vector<HandedIn> everybody;     // in alphabetical order
  std::vector<std::string> unclaimed;  // files of which nothing says whose they are
};

// Lists the submissions in a folder or an archive:
//   Canvas      files lovelaceada_LATE_123_456_hit_box-1.cpp; of resubmissions the last counts
//   Moodle      folders Ada Lovelace_123_assignsubmission_file, or files that begin so
//   Gradescope  folders submission_123, and submission_metadata.yml with the names
//   D2L         "12-34 - Ada Lovelace - Jan 15, 2027 1005 PM - hit_box.cpp"
//   Blackboard  hw_ada_attempt_2027-01-15-22-05-00_hit_box.cpp
//   other       a folder or an archive each
// Folders around everything are entered. In each submission, the task files are looked for
// however deep, and an archive is unpacked where there are none; the folder of the result is one in which
// base::read_submitted finds them. What is unpacked or copied lies below `work`; what a former call
// left there is removed. A submission that is a link, cannot be read, or leaves a choice
// has a problem. Throws pt::Error if there is nothing, or where the machine is at fault.
HandedInByAll handed_in(
    const std::string& input, const std::string& work, const std::vector<TaskFile>& tasks,
    const Unpack& unpack, const Progress& progress = [](std::size_t, std::size_t) {});

}  // namespace grader::intake
