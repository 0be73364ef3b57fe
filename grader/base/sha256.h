#pragma once

#include <string>
#include <string_view>

namespace grader::base {

// The digest in 64 hexadecimal digits (FIPS 180-4). Caches find their files by it: nobody can make
// two files with the same digest.
std::string sha256(std::string_view text);

}  // namespace grader::base
