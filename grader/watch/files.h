#pragma once

#include "grader/service/build/config.h"

#include <map>
#include <string>
#include <vector>

namespace grader::watch {

// Notices that task files were saved, however an editor does it: by writing, or by renaming a new
// file over the old one.
class Files {
 public:
  // `folder` has the tree of student/. The files that exist now count as seen.
  Files(std::string folder, const std::vector<build::TaskConfig>& tasks);

  // The slugs whose files have changed since the last call, in the order of the course. A missing
  // file has not changed: many editors remove it for a moment.
  std::vector<std::string> saved();

 private:
  std::string folder_;
  const std::vector<build::TaskConfig>& tasks_;
  std::map<std::string, std::string> stamps_;  // by slug
};

}  // namespace grader::watch
