#pragma once

#include <filesystem>
#include <string>

namespace pt {

// The text of a COLLADA file in UTF-8. Throws Error for a file that is missing, not a regular file,
// empty, too large, not COLLADA, or that takes tinyxml2 minutes or gigabytes to read.
std::string read_text(const std::filesystem::path& file);

}  // namespace pt
