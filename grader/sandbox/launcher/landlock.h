#pragma once

#include "grader/base/descriptor.h"
#include "grader/sandbox/launcher/options.h"

namespace grader::sandbox::box {

// The rules that let a program read what is visible, write in the folder, and touch no other file,
// no port and no process outside; not open where the kernel has no Landlock, or none is wanted. The paths are looked
// up now, by the user that this process is now. Throws pt::Error if one of them is not there.
base::Descriptor file_rules(const Options& options);

// Applies the rules to this process and all its descendants, for good. Does nothing if there are none.
void enforce(const base::Descriptor& rules);

}  // namespace grader::sandbox::box
