#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader::self_check {

// The names of the properties that a contract promises (grader/results/promises.h).
std::vector<std::string> promises_in(const std::filesystem::path& contract);

// The text behind "// breaks: " or "// right: " in the first line of a wrong or right solution;
// empty if there is none.
std::string first_line(const std::filesystem::path& file, const std::string& label);

}  // namespace grader::self_check
