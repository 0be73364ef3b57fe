#pragma once

#include "grader/judge/config.h"

#include <map>
#include <string>
#include <vector>

namespace grader::programs {

// Notices that task files were saved, however an editor does it: by writing, or by renaming a new
// file over the old one.
class Files {
 public:
  // `folder` has the tree of student/. The files that exist now count as seen.
  Files(std::string folder, const std::vector<judge::TaskConfig>& tasks);

  // The slugs whose files have changed since the last call, in the order of the course. A file that
  // is gone has not changed: many editors take it away for a moment.
  std::vector<std::string> saved();

 private:
  std::string folder_;
  const std::vector<judge::TaskConfig>& tasks_;
  std::map<std::string, std::string> stamps_;  // by slug
};

}  // namespace grader::programs
