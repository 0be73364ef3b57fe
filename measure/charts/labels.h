#pragma once

#include <string>
#include <vector>

namespace measure {

// A short name for each submission, a folder or an archive, in tables, charts and names of files: that of the folder, with those
// above it where two are alike. No name is "reference", and each can stand in a file name, a chart and a LaTeX file. Throws
// pt::Error if there are more than can be compared.
std::vector<std::string> labels_of(const std::vector<std::string>& paths);

}  // namespace measure
