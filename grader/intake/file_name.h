#pragma once

#include <cstddef>
#include <string>

namespace grader::intake {

// The ending of a file's name: ".cpp", ".tar.gz"; empty if it has none, or one that is too long to be one.
std::string ending_of(const std::string& name);

// A name of at most `most` bytes, which keeps its ending.
std::string cut_name(const std::string& name, std::size_t most);

// Makes a safe name for a file in a folder of ours: UTF-8, without control characters and without characters that change the
// direction of writing. It is cut, since a name may have 255 bytes, and an ID and the ending of a report may be added.
std::string as_file_name(const std::string& name);

// Equal for names that are one file where large and small letters are the same (macOS, Windows).
std::string folded(const std::string& name);

// Some systems write ë as one character, others as e and a mark (NFC and NFD of Unicode), and macOS takes both for one name.
// Returns whether a name has such marks.
bool has_marks(const std::string& name);

// Equal for a name with marks and the same name without. Others may be equal too: what has a mark is any letter with any mark.
std::string accents_alike(const std::string& name);

}  // namespace grader::intake
