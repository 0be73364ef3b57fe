#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Turns the exports of learning platforms into one folder for each learner. Archives are read as data.

namespace grader::intake {

// The file in which Gradescope says whose submission a folder is.
inline constexpr const char* kGradescopeList = "submission_metadata.yml";

// Returns whether the name is that of an archive: .zip, .tar.gz and the like.
bool is_archive(const std::string& name);

// Returns whether the name is that of an archive or packed file, whether it can be unpacked here or not.
bool is_packed(const std::string& name);

// An archive holds the work of one learner or of the class.
enum class Extent { one, everybody };

struct Bounds {
  int entries = 0;
  int files = 0;              // that are of use
  std::uint64_t bytes = 0;    // of these files
  std::int64_t unpacked = 0;  // bytes of all that is read
};
inline constexpr Bounds kBoundsOfOne{100'000, 5'000, std::uint64_t{64} << 20,
                                     std::int64_t{2} << 30};
inline constexpr Bounds kBoundsOfEverybody{2'000'000, 200'000, std::uint64_t{20} << 30,
                                           std::int64_t{64} << 30};

// `one`: for a learner's archive, and for each owner in an archive of the whole class.
struct Limits {
  Bounds one = kBoundsOfOne, everybody = kBoundsOfEverybody;
};

// Writes the files of an archive (zip, tar, 7-zip, RAR, compressed in any usual way) to `folder`, which is
// made: source files, archives, and kGradescopeList. Of other files the first few become empty files, so that
// it can be said what there is. Links and devices, hidden files, and paths that lead out of the folder are
// left out; where one of them has the name of a source file, there is a file that the compiler refuses, with
// the reason. Of two files of one path the last counts; in an archive of everybody's work they are a fault,
// if they differ.
//
// Throws pt::Error, one sentence, if it is not an archive, is damaged or encrypted, or is beyond
// the bounds; and another exception where the machine is at fault, as when the disk is full.
//
// In an archive of the whole class, each owner has the bounds of `one`. A fault in an entry belongs to its owner: read_faults
// returns it, and the others are unpacked. Every owner has a folder or a file, which may be empty. The owner is the first part
// of the path below the folders that all entries share, or the learner whom that part names (grader/intake/owner.h).
void unpack(const std::string& archive, const std::string& folder, Extent extent = Extent::one,
            const Limits& limits = {});

// The same of an archive that is open; sentences call it `name`.
void unpack(int archive, const std::string& name, const std::string& folder, Extent extent,
            const Limits& limits = {});

// The reason why part of an archive is not there.
struct Fault {
  std::string path;  // of an owner's folder or file
  std::string reason;
};

// The faults that unpack left in a folder.
std::vector<Fault> read_faults(const std::string& folder);

// A file that goes into an archive, and its path there.
struct Packed {
  std::string path, file;
};

// Writes a zip. Throws pt::Error if it cannot; then nothing is left of it.
void pack(const std::string& archive, const std::vector<Packed>& files);

}  // namespace grader::intake
