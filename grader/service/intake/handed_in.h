#pragma once

#include "grader/service/intake/owner.h"
#include "grader/service/intake/prepare_submission.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace grader::intake {

// The submission of one learner or of one group.
struct HandedIn {
  // The name of the learner or of the folder, safe as a file name: at most 200 bytes, no control
  // characters, and unique even if upper and lower case are the same.
  std::string name;
  std::string id;       // from the learning platform; may be empty
  std::string folder;   // of the files, in `work` or in their original place
  bool late = false;    // the platform says so
  std::string problem;  // the reason why it cannot be judged, in one sentence; else empty
  Platform platform = Platform::none;
  std::string feedback{};  // the path under which the platform takes a page back; empty: none
  std::string note{};      // which files count of those that differ, in one sentence; else empty
  std::optional<door::Course> course{};  // of a clone of the course: the files are made of it
  std::string handed_in{};  // when, "2027-01-15 22:05", or with Z behind it; empty: nothing says it
  int days_late = 0;        // days that had begun after the time due
  bool absent = false;      // a roster has the name, and nothing was handed in (kNothing)
};

// The problem of somebody who handed in nothing.
inline constexpr const char* kNothing = "nothing was handed in";

// Called when the number of submissions is known, and after each submission.
using Progress = std::function<void(std::size_t done, std::size_t all)>;

struct HandedInByAll {
  std::vector<HandedIn> everybody;     // in alphabetical order
  std::vector<std::string> unclaimed;  // files without a known owner
  bool work_is_unclaimed = false;      // some of them may be somebody's work
};

// Lists the submissions in a folder or an archive:
//   Canvas      files lovelaceada_LATE_123_456_hit_box-1.cpp; the last resubmission counts
//   Gradescope  folders submission_123, and submission_metadata.yml with the names
//   a table     forms of names of all other platforms (grader/name_forms.csv), and those that an instructor adds
//   other       one folder or archive per submission
// Leading folders that everything shares are skipped. prepare_submission finds the task files.
// Unpacked or copied files are put below `work`, from where files of an earlier call are removed.
// A submission that is a link, cannot be read, or is ambiguous has a problem, and so have two with
// one ID: of them nobody knows whose is whose, so they lose the ID. Throws pt::Error if there is no
// submission, or if the machine is at fault.
HandedInByAll handed_in(
    const std::string& input, const std::string& work, const std::vector<TaskFile>& tasks,
    const Readers& readers, const std::vector<NameForm>& table,
    const Progress& progress = [](std::size_t, std::size_t) {}, Attempt attempt = Attempt::last);

}  // namespace grader::intake
