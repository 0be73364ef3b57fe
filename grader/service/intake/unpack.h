#pragma once

#include "grader/service/intake/form_table.h"
#include "grader/service/intake/prepare_submission.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Unpacks exports of learning platforms to one folder per learner. Archives are untrusted data.

namespace grader::intake {

// Gradescope's list of who submitted which folder.
inline constexpr const char* kGradescopeList = "submission_metadata.yml";

struct Bounds {
  int entries = 0;
  int files = 0;              // that are kept
  std::uint64_t bytes = 0;    // of these files
  std::int64_t unpacked = 0;  // bytes of all entries that are read
};
inline constexpr Bounds kBoundsOfOne{100'000, 5'000, std::uint64_t{64} << 20,
                                     std::int64_t{2} << 30};
inline constexpr Bounds kBoundsOfEverybody{2'000'000, 200'000, std::uint64_t{20} << 30,
                                           std::int64_t{64} << 30};

// `one` is for a learner's archive, and for each owner in an archive of the whole class.
struct Limits {
  Bounds one = kBoundsOfOne, everybody = kBoundsOfEverybody;
};

// Writes source files, headers, archives and kGradescopeList from an archive (zip, tar, 7-zip, RAR,
// compressed in any usual way) to the new folder `folder`. The first few other files become empty
// files, so that messages can name them. Links, devices, hidden files, and paths that lead out of
// the folder are left out; instead of such a source file there is a file that the compiler refuses,
// with the reason. If a path occurs twice, and the files differ, the last file counts, and the one
// before it goes to a folder beside it; in an archive of the whole class it is a fault.
//
// Throws pt::Error, one sentence, if it is not an archive, is damaged or encrypted, or exceeds the
// bounds. Throws another exception if the machine is at fault, for example if the disk is full.
//
// In an archive of the whole class, each owner has the bounds of `one`. A fault in an entry belongs
// to its owner: read_faults returns it, and the other owners' files are unpacked. Every owner gets
// a folder or a file, which may be empty. The owner is the first part of the path below the folders
// that all entries share, or the learner named in that part (grader/service/intake/owner.h) by the forms in `table`.
void unpack(const std::string& archive, const std::string& folder, Extent extent = Extent::one,
            const Limits& limits = {}, const std::vector<NameForm>& table = {});

// Unpacks an open archive, which messages call `name`.
void unpack(int archive, const std::string& name, const std::string& folder, Extent extent,
            const Limits& limits = {}, const std::vector<NameForm>& table = {});

// The reason why part of an archive is missing.
struct Fault {
  std::string path;  // of an owner's folder or file
  std::string reason;
};

// The faults that unpack() wrote to a folder.
std::vector<Fault> read_faults(const std::string& folder);

// A file that goes into an archive, and its path there.
struct Packed {
  std::string path, file;
};

// Writes a zip. Throws pt::Error if that fails, and leaves no file.
void pack(const std::string& archive, const std::vector<Packed>& files);

}  // namespace grader::intake
