#pragma once

#include <string>
#include <vector>

namespace grader::intake {

// The folders and the name of an archive's entry; empty if it is hidden, absolute, or leads out of
// the folder. Windows writes \ for /. A part that is too long is cut before its ending.
std::vector<std::string> parts_of(const std::string& path);

// The parts of a path before the first hidden one; all parts if none is hidden; none if the path leads out of the folder.
std::vector<std::string> parts_before_hidden(const std::string& path);

// Returns whether an entry's path is absolute or leads out of the folder.
bool leads_out(const std::string& path);

// The number of leading folders that all paths share.
std::size_t folders_around(const std::vector<std::vector<std::string>>& paths);

// The first parts of a path, joined by /.
std::string joined(const std::vector<std::string>& parts, std::size_t count);

}  // namespace grader::intake
