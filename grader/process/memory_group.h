#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

// Bounds the memory of a child and of all that come from it together, where the machine lets this
// process make control groups of version 2 (Linux, Documentation/admin-guide/cgroup-v2): as root on most
// machines, as a user where systemd has handed a part of the tree on. Elsewhere the limits of each
// process are all there is (grader/process/limits.h).

namespace grader::process {

// The folder in which this process may make groups with a bound on memory; empty if there is none. A
// group with processes cannot hold such groups, so they are made beside our own group, or below it if
// it is the root. `mounts` and `groups` are the texts of /proc/self/mountinfo and /proc/self/cgroup.
std::string place_for_groups(const std::string& mounts, const std::string& groups);

// The groups that this process has made.
class MemoryGroups {
 public:
  // Below `place`, see above. Removes there what processes that are gone have left.
  explicit MemoryGroups(std::string place);
  ~MemoryGroups();
  MemoryGroups(const MemoryGroups&) = delete;
  MemoryGroups& operator=(const MemoryGroups&) = delete;

  // A new group, without processes, that kills all its processes where they use more memory together.
  // Returns an empty text if there can be none. Groups of children that have ended are removed on the way.
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
