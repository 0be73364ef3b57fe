#pragma once

#include "grader/process/limits.h"

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
  // The memory of the child and all its descendants together, in bytes, where there are control groups for it.
  std::optional<std::uint64_t> tree_memory{};
  // The starter of the child keeps this until the child is gone: the lock of its user, for example.
  std::shared_ptr<const void> held{};
};

// Starts the child in a process group of its own. It dies with the thread that started it, gains no
// privileges, leaves no core, and finds SIGPIPE ignored. This is the one place where programs
// start; those of a submission start in a box (grader/sandbox/box.h). Throws pt::Error if there is
// no process to be had; a program that cannot be run exits with 127.
pid_t spawn(const Child& child);

// Ends the child and its group. The caller still has to wait for it.
void end_child(pid_t pid);

// The same, and takes its exit status (as waitpid gives it).
int kill_child(pid_t pid);

// "signal 11 (Segmentation fault)" or "exit status 0".
std::string describe_status(int status);

// Other processes of the same user cannot read or trace this one any more.
void hide_process();

}  // namespace grader::process
