#pragma once

#include "grader/service/process/limits.h"

#include <string>
#include <vector>

#include <sys/types.h>

namespace grader::sandbox::box {

// The options of the launcher (written by grader/service/sandbox/box.cpp).
struct Options {
  bool inside = false;               // in bubblewrap: the first process of a namespace
  bool tools = false;                // the program may start others
  std::string folder;                // where it may write; empty: nowhere
  std::vector<std::string> visible;  // what it may read
  process::Limits limits;
  uid_t user = 0;    // inside: the user to become; 0: no change
  int started = -1;  // a descriptor for news of the start; -1: none
  int part =
      -1;  // the descriptor if this runs a part of a tool (run_tool_part in main.cpp); else -1
  long landlock = 1000;        // the newest version of Landlock to use; 0: none
  std::vector<char*> command;  // ends with nullptr, as exec wants it
};

// Throws pt::Error for unknown options.
Options parse(int count, char** words);

}  // namespace grader::sandbox::box
