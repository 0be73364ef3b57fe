#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace grader::platforms {

// A sketch of a source file by winnowing (Schleimer, Wilkerson, Aiken: Winnowing: Local Algorithms for Document Fingerprinting, 2003).
// Comments, layout, names and the values of numbers do not count. Each 12 tokens have a hash, and the least hash of each 8
// neighbours is kept: two files that share 19 tokens in a row share a print.
struct Print {
  std::uint64_t hash = 0;
  std::size_t first_line = 0, last_line = 0;  // of the tokens, from 1 on
};

// The prints in the order of the file. Of a longer file only the first 256 KiB count.
std::vector<Print> sketch_of(const std::string& source);

}  // namespace grader::platforms
