#pragma once

#include "grader/base/files.h"
#include "grader/judge/may_call.h"
#include "grader/tasks.h"

#include <functional>
#include <map>
#include <set>
#include <string>

namespace grader::judge {

// The headers of the project: path below the root ("pt/math/vec3.h") and text.
using Headers = std::map<std::string, std::string>;
Headers public_headers(const std::string& root);

// The paths of a header and of all that it includes, directly or not.
std::set<std::string> reached_from(const std::string& path, const Headers& all);

// The same for one task: in place of a header that it may not include there is one that says so, as
// an error of the compiler. A task may include its contract, those of what it may call, and every
// header that has nothing of the renderer in it: functions that are whole in a header need no
// linker, so that the audit does not see them.
Headers headers_for(const Task& task, const Headers& all);

// The code of a header as a compiler sees it: without comments and empty lines, where nothing asks for the number of a line.
std::string code_of(const std::string& header);

// A new folder in which a compiler or a linker works: what is put there, and nothing else. Everybody
// may read it. It is gone with this object.
class Stage {
 public:
  explicit Stage(const std::string& folder);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  const std::string& folder() const { return folder_; }

  // `file` is a path in it, "1_rays/hit_box.cpp". Both throw pt::Error where it cannot be written.
  void put(const std::string& file, const std::string& text) const;
  // A copy: whoever could change a link would change the file.
  void copy(const std::string& file, const std::string& from) const;

  // A file that was made in the folder.
  base::Submitted take(const std::string& name, std::size_t most) const;

 private:
  std::string folder_;
};

// The folder of files that stay as they are and that many compilers or linkers read: `work`/kept/`key`. Whoever
// needs it first fills it. A file that is made and removed a thousand times a minute costs more than what reads it.
std::string kept_folder(const std::string& work, const std::string& key,
                        const std::function<void(const Stage&)>& fill);

// Why nothing more can be written in the folder, or too little for a compiler, in a few words; empty
// if there is room. Looks at the disk as somebody who is not root finds it, too.
std::string lack_of_room(const std::string& folder);

}  // namespace grader::judge
