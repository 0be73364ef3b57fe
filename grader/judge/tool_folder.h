#pragma once

#include "grader/base/files.h"

#include <functional>
#include <string>

// Folders in which a compiler or a linker works.

namespace grader::judge {

// A new folder in which a compiler or a linker works: what is put there, and nothing else. Everybody
// may read it. It is gone with this object.
class ToolFolder {
 public:
  explicit ToolFolder(const std::string& folder);
  ~ToolFolder();
  ToolFolder(const ToolFolder&) = delete;
  ToolFolder& operator=(const ToolFolder&) = delete;

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
                        const std::function<void(const ToolFolder&)>& fill);

// The reason, in a few words, why nothing more can be written in the folder, or too little for a compiler; empty
// if there is room. It also counts the room that the disk has for somebody who is not root.
std::string lack_of_room(const std::string& folder);

}  // namespace grader::judge
