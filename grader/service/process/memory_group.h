#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

// Limits the memory of a child and all its descendants together, if this process may make control
// groups of version 2 (Linux, Documentation/admin-guide/cgroup-v2). Root may on most machines; a
// user may if systemd has delegated a part of the tree. Elsewhere each process only has its own
// limits (grader/service/process/limits.h).

namespace grader::process {

// The folder in which this process may make groups with a memory limit; empty if there is none. A
// group with processes cannot contain such groups, so they are made next to our own group, or below
// the root group. `mounts` and `groups` are the texts of /proc/self/mountinfo and
// /proc/self/cgroup.
std::string place_for_groups(const std::string& mounts, const std::string& groups);

// The groups that this process has made.
class MemoryGroups {
 public:
  // Makes groups below `place`, see above. Removes groups there whose judge has ended.
  explicit MemoryGroups(std::string place);
  ~MemoryGroups();
  MemoryGroups(const MemoryGroups&) = delete;
  MemoryGroups& operator=(const MemoryGroups&) = delete;

  // Makes an empty group that kills all its processes if together they use more memory. Returns an
  // empty text if that is impossible. Also removes the groups of children that have ended.
  std::string make(std::uint64_t bytes);

 private:
  void remove_empty();

  std::string place_;
  std::vector<std::string> made_;
  int serial_ = 0;
};

// Puts a process into a group: 0 is this one. Allocates nothing, so that it may be called between
// fork and exec. Returns false if the kernel refuses.
bool join_group(const char* group, pid_t pid);

}  // namespace grader::process
