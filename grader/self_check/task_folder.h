#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

// A promise as the contract writes it: "//   - keeps t inside the ray: ..." is
// keeps_t_inside_the_ray, and "(bonus)" at the end of the name becomes _bonus. Apostrophes are left
// out.
std::vector<std::string> promises_in(const std::filesystem::path& contract);

// What the first line of a wrong or right solution says after "// breaks: " or "// right: "; empty
// if it says nothing.
std::string first_line(const std::filesystem::path& file, const std::string& label);

// The .cpp files of a folder in alphabetical order; none if there is no such folder.
std::vector<std::filesystem::path> sources_in(const std::filesystem::path& folder);

}  // namespace grader
