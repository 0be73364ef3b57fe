#pragma once

#include "writeup/spec.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace writeup {

// The code that renders or measures: a program, and hashes of all that is in it.
struct Code {
  std::vector<std::string> command;             // a program, with its options
  std::map<std::string, std::string> hash;      // by task, and "framework"
  std::map<std::string, std::string> unusable;  // tasks that cannot run, each with the reason
};

// The code in writeup_render.<name>, by the list of objects beside it.
Code code_of_program(const std::filesystem::path& program);

// A name that stands for all code on which the pixels of a render depend.
std::string identity(const Code& code, const Spec& spec);

// "" or why the render cannot be made at all.
std::string obstacle(const Code& code, const Spec& spec);

}  // namespace writeup
