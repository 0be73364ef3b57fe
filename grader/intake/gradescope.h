#pragma once

#include <map>
#include <string>

namespace grader::intake {

// The learners who handed in a folder of Gradescope's export.
struct Submitters {
  std::string names, ids;  // joined; may be empty
};

// Reads Gradescope's list: the submitters by folder. An entry that is not what Gradescope writes names nobody. Throws
// pt::Error, with the line, if the list cannot be read.
std::map<std::string, Submitters> read_gradescope_list(const std::string& file);

}  // namespace grader::intake
