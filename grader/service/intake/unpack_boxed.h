#pragma once

#include "grader/service/intake/prepare_submission.h"

#include <string>

namespace grader::intake {

// Unpacks with the program `unpack` in the folder `programs`, in a box. `root` and `work` are the
// project's folder and the judge's folder, which probe_isolation needs. Where the program is
// missing, every archive has this as its problem. Throws pt::Error if nothing isolates, and
// something must.
Unpack unpack_boxed(const std::string& root, const std::string& work, const std::string& programs,
                    bool must_isolate);

}  // namespace grader::intake
