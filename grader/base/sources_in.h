#pragma once

#include <filesystem>
#include <vector>

namespace grader::base {

// The .cpp files of a folder in alphabetical order; none if there is no such folder.
std::vector<std::filesystem::path> sources_in(const std::filesystem::path& folder);

}  // namespace grader::base
