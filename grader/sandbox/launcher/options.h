#pragma once

#include "grader/process/limits.h"

#include <string>
#include <vector>

#include <sys/types.h>

namespace grader::sandbox::box {

// The options of the launcher (written by grader/sandbox/box.cpp).
struct Options {
  bool inside = false;               // bubblewrap: this is the first process of a namespace
  bool tools = false;                // the program may start others
  std::string folder;                // where it may write; empty: nowhere
  std::vector<std::string> visible;  // what it may read
  process::Limits limits;
  uid_t user = 0;        // inside: to become, not 0; 0: stay who it is
  int started = -1;      // a descriptor that is told of the start; -1: none
  int part = -1;         // this runs a part of a tool (tool_part.h): a descriptor; -1: it does not
  long landlock = 1000;  // the newest version of Landlock to use; 0: none
  std::vector<char*> command;  // ends with nullptr, as exec wants it
};

// Throws pt::Error for what it does not know.
Options parse(int count, char** words);

}  // namespace grader::sandbox::box
