#pragma once

#include <functional>
#include <string>
#include <vector>

namespace grader::intake {

enum class Platform { none, canvas, moodle, gradescope };

// The submission of one learner or of one group.
struct HandedIn {
  std::string name;     // unlike all others, and a file's name of at most 200 bytes without control
                        // characters: of the learner, or of the folder
  std::string id;       // that the learning platform has for it; may be empty
  std::string folder;   // of the files, in `work` or the place where they lay
  bool late = false;    // the platform says so
  std::string problem;  // the reason why it cannot be judged, in one sentence; else empty
  Platform platform = Platform::none;
  std::string feedback{};  // the path under which the platform takes a page back; empty: none
};

// Unpacks an archive to a folder that is not there yet. Returns why it could not; else empty.
using Unpack = std::function<std::string(const std::string& archive, const std::string& folder)>;

// Lists the submissions in a folder or an archive, in alphabetical order:
//   Canvas      files lovelaceada_LATE_123_456_hit_box-1.cpp; of resubmissions the last counts
//   Moodle      folders Ada Lovelace_123_assignsubmission_file
//   Gradescope  folders submission_123, and submission_metadata.yml with the names
//   other       a folder or an archive each
// Archives inside are unpacked below `work`, and files of Canvas are copied there; what a former call
// left there is removed. A submission that is a link, cannot be unpacked, or holds two archives and
// no file, has a problem. Throws pt::Error if there is nothing.
std::vector<HandedIn> handed_in(const std::string& input, const std::string& work,
                                const Unpack& unpack);

}  // namespace grader::intake
