#pragma once

#include "grader/judge/files.h"

#include <map>
#include <string>

namespace grader {

// The headers that a submission may include: path below the root ("pt/math/vec3.h") and text.
using Headers = std::map<std::string, std::string>;
Headers public_headers(const std::string& root);

// A new folder in which a file is compiled: the headers, the file, and nothing else. Everybody may
// read it. It is gone with this object.
class Stage {
 public:
  // `file` is a path in it, "1_rays/hit_box.cpp".
  Stage(const std::string& folder, const Headers& headers, const std::string& file,
        const std::string& text);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  const std::string& folder() const { return folder_; }

  // A file that was made in the folder.
  Submitted take(const std::string& name, std::size_t most) const;

 private:
  std::string folder_;
};

}  // namespace grader
