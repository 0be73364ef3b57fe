#pragma once

#include "grader/intake/handed_in.h"
#include "grader/intake/unpack.h"
#include "tests/temporary_folder.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <archive_entry.h>
#include <gtest/gtest.h>

// Classes that are handed in, for the tests of the intake.
namespace grader::intake {

struct Entry {
  std::string path, text;
  int type = AE_IFREG;
  std::string points_to{};
};

enum class Format { zip, zip_stored, zip_encrypted, tar_gz, tar_xz, tar_zst, seven_zip };

// The bytes of an archive with these entries, as others' programs make them.
std::string archive_of(const std::vector<Entry>& entries, Format format = Format::zip);

// Bounds that a small archive exceeds. An archive of everybody's work has the usual ones.
inline const Limits kSmall{{1000, 20, std::uint64_t{2} << 20, kBoundsOfOne.unpacked},
                           kBoundsOfEverybody};

// The tasks of which there are files.
inline const std::vector<TaskFile> kTasks{{"1_rays", "hit_sphere"},
                                          {"1_rays", "hit_triangle"},
                                          {"1_rays", "hit_box"},
                                          {"2_bvh", "hit_bvh"}};

using Files = std::map<std::string, std::string>;

// A class in in(), and what becomes of it.
class Intake : public testing::Test {
 protected:
  void SetUp() override;

  std::filesystem::path in(const std::string& path = "") const {
    return std::filesystem::path(folder_.path()) / "in" / path;
  }
  void add(const std::string& path, const std::string& text) const;

  // By name: "id late problem", and the text of each source file by its path.
  struct Seen {
    std::string id, problem;
    bool late = false;
    Platform platform = Platform::none;
    std::string feedback{};
    std::map<std::string, std::string> files{};
    std::map<std::string, std::string> judged{};  // what the judge reads, by task
  };
  std::map<std::string, Seen> seen(const std::filesystem::path& input) const;
  std::map<std::string, Seen> seen() const { return seen(in()); }

  TemporaryFolder folder_;
  Limits limits_;
  mutable std::vector<std::string> unclaimed_;  // of the last call
};

}  // namespace grader::intake
