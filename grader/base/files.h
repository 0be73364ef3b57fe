#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace grader::base {

// The folder of the grader's programs. It is next to the folder of this program, as build/check/grader is next to
// build/check/measure and build/check/tests.
std::string programs_folder();

// A text that changes whenever the file's content may have changed: its path, size and time.
std::string stamp(const std::string& path);

// A file that somebody else made.
struct Submitted {
  bool present = false;
  std::string rejected;  // the reason why the file is not accepted; empty if it is
  std::string text;
};

// The file `name` in an open folder: a link, hard or soft, anything but a regular file, and a file
// larger than `most` bytes are rejected.
Submitted read_plain_file(int folder, const std::string& name, std::size_t most);

inline constexpr std::size_t kMaxFile = std::size_t{1} << 20;

// The folders of a submission in which a task file of this part may lie. The first that has it counts:
// 1_rays, student/1_rays, the top, student.
std::array<std::filesystem::path, 4> places_of(const std::string& part);

// Reads the file of a task, without following a link below the folder: anything but a regular file,
// and a file larger than kMaxFile, are rejected. It is looked for in places_of(part). Throws pt::Error if
// the folder does not exist.
Submitted read_submitted(const std::string& folder, const std::string& part,
                         const std::string& slug);

// Returns whether a name begins with a dot (.git, .DS_Store, also ..) or is __MACOSX: programs make such
// files, people do not.
bool is_hidden(const std::string& name);

// The folder in which the tree of a submission starts: the given one or, while that contains only
// one folder, as in unpacked archives, this folder. Hidden files do not count. The folders of a tree
// (student, 1_rays) are never entered. Throws pt::Error if a folder on the way cannot be read.
std::string submission_root(const std::string& folder);

// The .cpp files of a folder in alphabetical order; none if it does not exist.
std::vector<std::filesystem::path> sources_in(const std::filesystem::path& folder);

}  // namespace grader::base
