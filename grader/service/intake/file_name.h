#pragma once

#include <cstddef>
#include <string>

namespace grader::intake {

// The ending of a file name: ".cpp", ".tar.gz"; empty if there is none, or if it is too long.
std::string ending_of(const std::string& name);

// The name, cut to at most `most` bytes; it keeps its ending.
std::string cut_name(const std::string& name, std::size_t most);

// Makes a safe name for a file in one of our folders: UTF-8, without control characters and without
// characters that change the writing direction. It is short enough to add an ID and the ending of a
// report: a name may have 255 bytes.
std::string as_file_name(const std::string& name);

std::string lower_case(std::string text);

// Returns whether the name ends like an archive's: .zip, .tar.gz and so on.
bool is_archive(const std::string& name);

// Returns whether the name ends like that of any archive or packed file, supported or not.
bool is_packed(const std::string& name);

// Returns whether the name ends like a source file's: .cpp, .cpp.txt.
bool is_source(const std::string& name);

// Returns equal texts for names that differ only in upper and lower case (macOS, Windows).
std::string folded(const std::string& name);

// Returns whether a name has accents written as separate marks. Some systems write ë as one
// character, others as e and a mark (NFC and NFD of Unicode); macOS takes both for the same name.
bool has_marks(const std::string& name);

// Returns equal texts for a name with marks and the same name without. Any letter with any mark
// counts as the same.
std::string accents_alike(const std::string& name);

}  // namespace grader::intake
