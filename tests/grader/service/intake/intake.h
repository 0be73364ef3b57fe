#pragma once

#include "grader/service/intake/handed_in.h"
#include "grader/service/intake/unpack.h"
#include "tests/fixtures/temporary_folder.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <archive_entry.h>
#include <gtest/gtest.h>

// Classes of submissions, for the tests of the intake.
namespace grader::intake {

struct Entry {
  std::string path, text;
  int type = AE_IFREG;
  std::string points_to{};
};

enum class Format { zip, zip_stored, zip_encrypted, tar_gz, tar_bz2, tar_xz, tar_zst, seven_zip };

// The bytes of an archive with these entries, as other programs make it.
std::string archive_of(const std::vector<Entry>& entries, Format format = Format::zip);

// The project's own forms of names.
const std::vector<NameForm>& known_forms();

// Bounds that a small archive exceeds. The archive of a whole class has the usual bounds.
inline const Limits kSmall{{1000, 20, std::uint64_t{2} << 20, kBoundsOfOne.unpacked},
                           kBoundsOfEverybody};

// The tasks that have files.
inline const std::vector<TaskFile> kTasks{{"1_rays", "hit_sphere"},
                                          {"1_rays", "hit_triangle"},
                                          {"1_rays", "hit_box"},
                                          {"2_bvh", "hit_bvh"}};

using Files = std::map<std::string, std::string>;

// A class in in() and its fate.
class Intake : public testing::Test {
 protected:
  void SetUp() override;

  std::filesystem::path in(const std::string& path = "") const {
    return std::filesystem::path(folder_.path()) / "in" / path;
  }
  void add(const std::string& path, const std::string& text) const;

  // One submission, by its learner's name; `files` has the text of each source file by its path.
  struct Seen {
    std::string id, problem;
    bool late = false;
    Platform platform = Platform::none;
    std::string feedback{}, note{};
    std::map<std::string, std::string> files{};
    std::map<std::string, std::string>
        judged{};  // what the judge reads, by task, or why it rejects it
    std::optional<door::Course> course{};
  };
  // It also expects that each folder and archive of a learner gives the same without its class.
  std::map<std::string, Seen> seen(const std::filesystem::path& input) const;
  std::map<std::string, Seen> seen() const { return seen(in()); }

  TemporaryFolder folder_;
  Limits limits_;
  std::vector<NameForm> forms_ = known_forms();
  mutable std::vector<std::string> unclaimed_;  // of the last call
  mutable bool work_is_unclaimed_ = false;

 private:
  void expect_the_same_at_the_other_doors(const std::filesystem::path& input,
                                          const std::map<std::string, Seen>& all,
                                          const Readers& readers) const;
};

}  // namespace grader::intake
