#pragma once

#include "grader/base/files.h"

#include <functional>
#include <string>

// Folders in which a compiler or a linker works.

namespace grader::build {

// A new folder in which a compiler or a linker works. It contains only what is put there, and
// everybody may read it. The destructor removes it.
class ToolFolder {
 public:
  explicit ToolFolder(const std::string& folder);
  ~ToolFolder();
  ToolFolder(const ToolFolder&) = delete;
  ToolFolder& operator=(const ToolFolder&) = delete;

  const std::string& folder() const { return folder_; }

  // `file` is a path in the folder: "1_rays/hit_box.cpp". Both throw pt::Error on failure.
  void put(const std::string& file, const std::string& text) const;
  // This makes a copy, not a link: a tool that changes a link would change the file itself.
  void copy(const std::string& file, const std::string& from) const;

  // The path of a file that the tool made.
  base::Submitted take(const std::string& name, std::size_t most) const;

 private:
  std::string folder_;
};

// The folder `work`/kept/`key` of constant files for many tools. The first caller fills it. Making
// and removing a file a thousand times per minute costs more than reading it.
std::string kept_folder(const std::string& work, const std::string& key,
                        const std::function<void(const ToolFolder&)>& fill);

// The reason, in a few words, why the folder has no room for a compiler's output; empty if it has.
// Only room that the disk has for somebody who is not root counts.
std::string lack_of_room(const std::string& folder);

}  // namespace grader::build
