#pragma once

#include <string>
#include <string_view>

namespace grader::base {

// The digest in 64 hexadecimal digits (FIPS 180-4). What is cached is found by it: nobody can make
// two files with the same one.
std::string sha256(std::string_view text);

}  // namespace grader::base
