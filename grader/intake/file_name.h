#pragma once

#include <cstddef>
#include <string>

namespace grader::intake {

// The ending of a file's name: ".cpp", ".tar.gz"; empty if it has none, or one that is too long to be one.
std::string ending_of(const std::string& name);

// A name of at most `most` bytes, which keeps its ending.
std::string cut_name(const std::string& name, std::size_t most);

// A file's name for a folder of our own, whatever a platform allows in a name: UTF-8 without control
// characters and without those that turn the direction of writing. Of the names of a large group the beginning: a file's name
// has 255 bytes at most, and reports have endings.
std::string as_file_name(const std::string& name);

// Equal for names that are one file where large and small letters are the same (macOS, Windows).
std::string folded(const std::string& name);

// Some systems write ë as one character, others as e and a mark (NFC and NFD of Unicode), and macOS takes both for one name.
// Returns whether a name has such marks.
bool has_marks(const std::string& name);

// Equal for a name with marks and the same name without. Others may be equal too: what has a mark is any letter with any mark.
std::string accents_alike(const std::string& name);

}  // namespace grader::intake
