#pragma once

#include "writeup/code.h"
#include "writeup/options.h"

namespace writeup {

// Returns the code of a submission. The program writeup_boxed compiles it in the box, and renders
// with it. No line of it runs in this process.
Code code_of_submission(const Options& options);

// The same code in the program accuracy_boxed.
Code accuracy_of_submission(const Options& options, const Code& code);

// The same code in the program that shows the paths of a pixel. It is compiled only if it `is_wanted`.
Code view_of_submission(const Options& options, const Code& code, bool is_wanted);

}  // namespace writeup
