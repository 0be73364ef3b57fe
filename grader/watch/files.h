#pragma once

#include "grader/service/build/config.h"

#include <map>
#include <string>
#include <vector>

namespace grader::watch {

// The end of the name of a file of examples, before .cpp: "hit_sphere.examples".
inline constexpr const char* kExamples = ".examples";

// Notices that task files, or examples of a task, were saved, however an editor does it: by writing, or by renaming a new
// file over the old one.
class Files {
 public:
  // `folder` has the tree of student/, or is a clone of the course's skeleton. The files that exist
  // now count as seen.
  Files(std::string folder, const build::Config& config);

  // The slugs whose files have changed since the last call, in the order of the course; for a file of examples "hit_sphere.examples".
  // A missing file has not changed: many editors remove it for a moment. Of a clone, the tasks whose functions
  // have changed; if there are none, those whose text has, with all that it includes.
  std::vector<std::string> saved();

 private:
  // The text of a task that is made of a clone, and in it the learner's own functions.
  struct Made {
    std::string text, functions;
    bool operator==(const Made&) const = default;
  };

  std::vector<std::string> saved_in_clone();
  std::map<std::string, Made> made() const;

  std::string folder_;
  const build::Config& config_;
  std::map<std::string, std::string> stamps_;  // by name; of a clone, by path
  std::map<std::string, Made> made_;           // by slug
};

}  // namespace grader::watch
