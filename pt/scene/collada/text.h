#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pt {

// The text of a COLLADA file in UTF-8. Throws Error for a file that is missing, not a regular file,
// empty, too large, not COLLADA, or that takes tinyxml2 minutes or gigabytes to read.
std::string read_text(const std::filesystem::path& file);

// Returns whether numbers are written as 0,5 and none as 0.5. The text of <asset> does not count:
// it has versions of programs.
bool has_decimal_commas(std::string_view xml);

}  // namespace pt
