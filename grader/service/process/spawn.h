#pragma once

#include "grader/service/process/limits.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace grader::process {

struct Child {
  std::vector<std::string> command;      // argv; the program is a path
  std::vector<std::string> environment;  // "NAME=value", all of it
  std::vector<int> descriptors;          // entry i becomes descriptor i; all others are closed
  std::string directory;                 // to run in; empty: this one
  Limits limits;
  // The memory limit for the child and its descendants together, in bytes; needs control groups.
  std::optional<std::uint64_t> tree_memory{};
  // The caller keeps this until the child has ended: the lock of its user, for example.
  std::shared_ptr<const void> held{};
};

// The whole environment of this process, for programs of our own.
std::vector<std::string> own_environment();

// Starts the child in a process group of its own. It dies with the thread that started it, gains no
// privileges, leaves no core, and ignores SIGPIPE. All programs start here; those of a submission
// start in a box (grader/service/sandbox/box.h). Throws pt::Error if no process can be made; a
// program that cannot be run exits with 127.
pid_t spawn(const Child& child);

// Ends the child and its group. The caller still has to wait for it.
void end_child(pid_t pid);

// Does the same, waits, and returns its exit status as waitpid gives it.
int kill_child(pid_t pid);

// "signal 11 (Segmentation fault)" or "exit status 0".
std::string describe_status(int status);

// From now on other processes of the same user cannot read or trace this process.
void hide_process();

}  // namespace grader::process
