#pragma once

#include "measure/renders/spec.h"
#include "writeup/options.h"

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

// Returns the code in writeup_render.<name>, from the list of objects next to it.
Code code_of_program(const std::filesystem::path& program);

// Returns the code of a submission. The program writeup_boxed compiles it in the box, and renders
// with it. No line of it runs in this process.
Code code_of_submission(const Options& options, const std::string& submission,
                        const std::string& label);

// The same code in the program accuracy_boxed; or several, which it compares with the reference.
Code accuracy_of_submission(const Options& options, const Code& code, const std::string& label);
Code accuracy_of_several(const Options& options, const std::map<std::string, Code>& codes);

// The same code in the program that shows the paths of a pixel. It is compiled only if it `is_wanted`.
Code view_of_submission(const Options& options, const Code& code, bool is_wanted);

// Returns a name for all code on which the pixels of a render depend.
std::string identity(const Code& code, const measure::Spec& spec);

// Returns the reason why the render cannot be made at all, or "".
std::string obstacle(const Code& code, const measure::Spec& spec);

}  // namespace writeup
