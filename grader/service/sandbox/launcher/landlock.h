#pragma once

#include "grader/base/descriptor.h"
#include "grader/service/sandbox/launcher/options.h"

namespace grader::sandbox::box {

// The rules that let a program read the visible paths, write in the folder, and use no other file,
// no port and no process outside. Not open if the kernel has no Landlock, or it is not wanted.
// Paths are looked up now, as the current user. Throws pt::Error if one does not exist.
base::Descriptor file_rules(const Options& options);

// Applies the rules, irrevocably, to this process and its descendants. Does nothing without rules.
void enforce(const base::Descriptor& rules);

}  // namespace grader::sandbox::box
