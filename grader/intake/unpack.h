#pragma once

#include <string>
#include <vector>

// Turns the exports of learning platforms into one folder for each learner. Archives are read as data.

namespace grader::intake {

// The file in which Gradescope says whose submission a folder is.
inline constexpr const char* kGradescopeList = "submission_metadata.yml";

// Returns whether the name is that of an archive: .zip, .tar.gz and the like.
bool is_archive(const std::string& name);

// Writes the files of an archive (zip, tar, 7-zip, compressed in any usual way) to `folder`, which is
// made: source files, archives, and kGradescopeList; nothing else is of use here. Links
// and devices, hidden files, and paths that lead out of the folder are left out. Of two files of one
// path the first counts.
//
// Throws pt::Error, one sentence, if it is not an archive, is damaged or encrypted, or would become
// too large: more than 64 MiB of such files, 5,000 of them, 100,000 entries, or 2 GiB in all.
void unpack(const std::string& archive, const std::string& folder);

// The same of an archive that is open; sentences call it `name`.
void unpack(int archive, const std::string& name, const std::string& folder);

// A file that goes into an archive, and its path there.
struct Packed {
  std::string path, file;
};

// Writes a zip. Throws pt::Error if it cannot; then nothing is left of it.
void pack(const std::string& archive, const std::vector<Packed>& files);

}  // namespace grader::intake
