#pragma once

#include "writeup/code.h"
#include "writeup/options.h"

namespace writeup {

// The code of a submission: compiled in the box, by the program writeup_boxed, which renders with it
// too. No line of it runs in this process.
Code code_of_submission(const Options& options);

// The same in the program accuracy_boxed.
Code accuracy_of_submission(const Options& options, const Code& code);

}  // namespace writeup
