// The folder of a submission and its files, which somebody else made.
#include "grader/base/files.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/fixtures/temporary_folder.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace grader::base {
namespace {

namespace fs = std::filesystem;

std::string error_of(const std::string& folder) {
  try {
    read_submitted(submission_root(folder), "1_rays", "hit_sphere");
    return "";
  } catch (const pt::Error& error) {
    return error.what();
  }
}

// Root may read everything.
class AsNobody {
 public:
  AsNobody() {
    if (is_root_ && seteuid(65534) != 0) is_root_ = false;
  }
  ~AsNobody() {
    if (is_root_ && seteuid(0) != 0) std::abort();
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  bool is_root_ = geteuid() == 0;
};

TEST(SubmittedFolder, that_cannot_be_read_is_an_error_with_a_sentence) {
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms(0755));
  const std::string inner = folder.path() + "/ada";
  fs::create_directory(inner);
  fs::permissions(inner, fs::perms::none);
  {
    const AsNobody nobody;
    const std::string words = ": cannot be read (Permission denied); make the folder readable";
    EXPECT_EQ(error_of(folder.path()), inner + words);
    EXPECT_EQ(error_of(inner), inner + words);
  }
  fs::permissions(inner, fs::perms(0755));
  EXPECT_EQ(error_of(folder.path()), "");
}

TEST(SubmittedFolder, that_is_none_is_an_error_with_a_sentence) {
  const TemporaryFolder folder;
  const std::string loop = folder.path() + "/loop";
  fs::create_symlink("loop", loop);
  EXPECT_EQ(error_of(folder.path() + "/none"),
            folder.path() + "/none is not a folder; name one with --submission");
  EXPECT_NE(error_of(loop).find(loop + ": cannot be read"), std::string::npos) << error_of(loop);
}

TEST(SubmittedFile, that_is_not_utf_8_is_named) {
  const TemporaryFolder folder;
  using namespace std::string_literals;
  const std::string reason = "the file is UTF-16 or UTF-32; save it as UTF-8";
  for (const auto& [text, rejected] :
       std::vector<std::pair<std::string, std::string>>{{"\xff\xfe#\0i\0"s, reason},
                                                        {"\xfe\xff\0#\0i"s, reason},
                                                        {"#\0i\0"s, reason},
                                                        {"\0#\0i"s, reason},
                                                        {"\xff\xfe\0\0#\0\0\0"s, reason},
                                                        {"\0\0\xfe\xff\0\0\0#"s, reason},
                                                        {"\xef\xbb\xbf#include", ""},
                                                        {"#include \"\xc3\xa9.h\"", ""},
                                                        {"", ""}}) {
    pt::write_file(folder.path() + "/hit_sphere.cpp", text);
    const Submitted file = read_submitted(folder.path(), "1_rays", "hit_sphere");
    EXPECT_TRUE(file.present);
    EXPECT_EQ(file.rejected, rejected) << text;
  }
}

}  // namespace
}  // namespace grader::base
