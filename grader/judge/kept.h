#pragma once

#include <string>
#include <string_view>
#include <vector>

// Files and folders that are kept from run to run, with checksums: after a loss of power, a file may be empty or cut
// off. Other judges may use the folders at the same time.
namespace grader::judge {

// The size and a checksum of bytes, and of a file; empty if the file cannot be read. They find damage, and no
// attacker: nobody but the judge writes there.
std::string sum_of(std::string_view bytes);
std::string sum_of_file(const std::string& path);

// Writes the sum beside the file, as <path>.sum: before the file itself, which counts from then on.
void note_sum(const std::string& path, const std::string& sum);

// The file with its sum.
void keep_file(const std::string& path, const std::string& bytes);

// Returns whether the file is there, as its sum says.
bool is_whole(const std::string& path);

// The same for files that belong together, as a verdict and its pictures do: all their sums in <path>.sum, noted
// when the last of them is written. A file that is missing is noted as missing.
void note_sums_of(const std::string& path, const std::vector<std::string>& files);
bool are_whole(const std::string& path, const std::vector<std::string>& files);

// The same for a folder, with the sums of all its files in one file in it.
void note_sums(const std::string& folder);
bool is_whole_folder(const std::string& folder);

// Keeps the folder from being removed by any judge until this process ends. Returns whether it is there.
bool use_folder(const std::string& folder);

// Removes the folders beside this one that no process uses and that nobody has used within kInUse: those of other
// versions of the project, its compiler or its flags. A time in the future means that the clock was set back.
void remove_unused_beside(const std::string& folder);

}  // namespace grader::judge
