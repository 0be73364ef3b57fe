#pragma once

#include "grader/tasks.h"

#include <map>
#include <set>
#include <string>

// The headers that a submission is compiled with.

namespace grader::build {

// The headers of the project: path below the root ("pt/math/vec3.h") and text.
using Headers = std::map<std::string, std::string>;
Headers public_headers(const std::string& root);

// The paths of a header and of all that it includes, directly or not.
std::set<std::string> reached_from(const std::string& path, const Headers& all);

// The headers for one task. A header that the task may not include is replaced by an #error that
// says so. A task may include its contract, the contracts of all it may call, and every header
// without any code of the renderer. Inline functions of a header need no linker, so the audit would
// not see them.
Headers headers_for(const Task& task, const Headers& all);

// The code of a header without comments and empty lines; unchanged if it may use line numbers.
std::string code_of(const std::string& header);

}  // namespace grader::build
