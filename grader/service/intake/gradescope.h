#pragma once

#include <map>
#include <string>

namespace grader::intake {

// The learners who submitted a folder of Gradescope's export.
struct Submitters {
  std::string names, ids;   // of all of them, joined; may be empty
  std::string handed_in{};  // when, as the list writes it; may be empty
};

// Reads Gradescope's list of submitters, by folder. Malformed entries name nobody. Throws
// pt::Error, with the line, if the list cannot be read.
std::map<std::string, Submitters> read_gradescope_list(const std::string& file);

}  // namespace grader::intake
