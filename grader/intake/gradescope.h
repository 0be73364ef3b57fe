#pragma once

#include <map>
#include <string>

namespace grader::intake {

// The learners who handed in a folder of Gradescope's export.
struct Submitters {
  std::string names, ids;  // joined; may be empty
};

// Reads Gradescope's list: the submitters by folder. Throws pt::Error, with the line, if it cannot be read.
std::map<std::string, Submitters> read_gradescope_list(const std::string& file);

}  // namespace grader::intake
