#pragma once

#include "grader/tasks.h"

#include <map>
#include <set>
#include <string>

// The headers that a submission is compiled with.

namespace grader::judge {

// The headers of the project: path below the root ("pt/math/vec3.h") and text.
using Headers = std::map<std::string, std::string>;
Headers public_headers(const std::string& root);

// The paths of a header and of all that it includes, directly or not.
std::set<std::string> reached_from(const std::string& path, const Headers& all);

// The same for one task: in place of a header that it may not include there is one that says so, as
// an error of the compiler. A task may include its contract, those of what it may call, and every
// header that has nothing of the renderer in it: functions that are whole in a header need no
// linker, so that the audit does not see them.
Headers headers_for(const Task& task, const Headers& all);

// The code of a header as a compiler sees it: without comments and empty lines, where nothing asks for the number of a line.
std::string code_of(const std::string& header);

}  // namespace grader::judge
