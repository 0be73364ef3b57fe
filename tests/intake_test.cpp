// Exports of learning platforms become one folder per learner; archives are read as data.
#include "grader/intake/handed_in.h"
#include "grader/intake/unpack.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/temporary_folder.h"

#include <filesystem>
#include <map>

#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace grader::intake {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Entry {
  std::string path, text;
  int type = AE_IFREG;
  std::string points_to{};
};

enum class Format { zip, tar_gz };

// The bytes of an archive with these entries, as others' programs make them.
std::string archive_of(const std::vector<Entry>& entries, Format format = Format::zip) {
  std::string bytes(std::size_t{8} << 20, '\0');
  std::size_t used = 0;
  archive* out = archive_write_new();
  if (format == Format::zip) {
    archive_write_set_format_zip(out);
  } else {
    archive_write_set_format_pax_restricted(out);
    archive_write_add_filter_gzip(out);
  }
  archive_write_open_memory(out, bytes.data(), bytes.size(), &used);
  for (const Entry& each : entries) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname_utf8(entry, each.path.c_str());
    archive_entry_set_filetype(entry, static_cast<unsigned>(each.type));
    archive_entry_set_perm(entry, 0644);
    if (each.type == AE_IFLNK) archive_entry_set_symlink(entry, each.points_to.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(each.text.size()));
    archive_write_header(out, entry);
    archive_write_data(out, each.text.data(), each.text.size());
    archive_entry_free(entry);
  }
  archive_write_close(out);
  archive_write_free(out);
  bytes.resize(used);
  return bytes;
}

class Intake : public testing::Test {
 protected:
  void SetUp() override {
    std::setlocale(LC_ALL, "C.UTF-8");
    fs::create_directories(in());
  }

  fs::path in(const std::string& path = "") const { return fs::path(folder_.path()) / "in" / path; }
  void add(const std::string& path, const std::string& text) const {
    fs::create_directories(in(path).parent_path());
    pt::write_file(in(path), text);
  }

  // By name: "id late problem", and the text of each source file by its path.
  struct Seen {
    std::string id, problem;
    bool late = false;
    std::map<std::string, std::string> files;
  };
  std::map<std::string, Seen> seen(const fs::path& input) const {
    const auto unpack_here = [](const std::string& archive, const std::string& folder) {
      try {
        unpack(archive, folder);
        return std::string();
      } catch (const pt::Error& error) {
        return std::string(error.what());
      }
    };
    std::map<std::string, Seen> all;
    for (const HandedIn& each : handed_in(input, folder_.path() + "/work", unpack_here)) {
      Seen one{each.id, each.problem, each.late, {}};
      if (!each.folder.empty() && fs::exists(each.folder)) {
        for (const auto& file : fs::recursive_directory_iterator(each.folder)) {
          if (file.path().extension() != ".cpp" || file.is_symlink()) continue;
          one.files[fs::relative(file.path(), each.folder)] = pt::read_file(file.path(), 10000);
        }
      }
      EXPECT_TRUE(all.emplace(each.name, one).second) << each.name << " twice";
    }
    return all;
  }
  std::map<std::string, Seen> seen() const { return seen(in()); }

  TemporaryFolder folder_;
};

using Files = std::map<std::string, std::string>;

TEST_F(Intake, folders_and_archives_of_any_name_are_submissions) {
  add("ada/1_rays/hit_box.cpp", "a");
  add("bob.zip", archive_of({{"tree/student/1_rays/hit_box.cpp", "b"}, {"tree/notes.txt", "n"}}));
  add("Łukasz 北.tar.gz", archive_of({{"hit_box.cpp", "c"}}, Format::tar_gz));
  add("notes.txt", "of the instructor");
  auto all = seen();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all["ada"].files, (Files{{"1_rays/hit_box.cpp", "a"}}));
  EXPECT_EQ(all["bob"].files, (Files{{"tree/student/1_rays/hit_box.cpp", "b"}}));
  EXPECT_EQ(all["Łukasz 北"].files, (Files{{"hit_box.cpp", "c"}}));
}

TEST_F(Intake, canvas_gives_files_of_which_the_last_counts) {
  add("lovelaceada_123_900_hit_box.cpp", "old");
  add("lovelaceada_123_901_hit_box-1.cpp", "newer");
  add("lovelaceada_LATE_123_902_hit_box-10.cpp", "newest");
  add("lovelaceada_123_903_hit_sphere.cpp", "s");
  add("hopper_7_904_work.zip", archive_of({{"student/hit_box.cpp", "h"}}));
  add("hopper_8_905_hit_box.cpp", "another Hopper");
  auto all = seen();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all["lovelaceada"].files, (Files{{"hit_box.cpp", "newest"}, {"hit_sphere.cpp", "s"}}));
  EXPECT_TRUE(all["lovelaceada"].late);
  EXPECT_EQ(all["lovelaceada"].id, "123");
  EXPECT_EQ(all["hopper (7)"].files, (Files{{"student/hit_box.cpp", "h"}}));
  EXPECT_FALSE(all["hopper (7)"].late);
  EXPECT_EQ(all["hopper (8)"].files, (Files{{"hit_box.cpp", "another Hopper"}}));
}

TEST_F(Intake, moodle_gives_folders_with_what_was_handed_in) {
  add("Ada Lovelace_55_assignsubmission_file_/work.zip",
      archive_of({{"__MACOSX/1_rays/._hit_box.cpp", "mac"}, {"1_rays/hit_box.cpp", "a"}}));
  add("Grace O'Hopper_56_assignsubmission_file/hit_box.cpp", "g");
  add("Grace O'Hopper_56_assignsubmission_file/.DS_Store", "mac");
  auto all = seen();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all["Ada Lovelace"].files, (Files{{"1_rays/hit_box.cpp", "a"}}));
  EXPECT_EQ(all["Ada Lovelace"].id, "55");
  EXPECT_EQ(all["Grace O'Hopper"].files, (Files{{"hit_box.cpp", "g"}}));
}

TEST_F(Intake, gradescope_names_its_folders_in_a_list) {
  pt::write_file(
      in("export.zip"),
      archive_of({{"assignment_1_export/submission_metadata.yml",
                   "submission_1:\n  :submitters:\n  - :name: Ada / Lovelace\n    :sid: '007'\n"
                   "submission_2:\n  :submitters:\n  - :name: Bob\n    :sid: 8\n"
                   "  - :name: Eve\n    :sid: 9\n"},
                  {"assignment_1_export/submission_1/hit_box.cpp", "a"},
                  {"assignment_1_export/submission_2/x/hit_box.cpp", "b"}}));
  auto all = seen(in("export.zip"));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all["Ada _ Lovelace"].files, (Files{{"hit_box.cpp", "a"}}));
  EXPECT_EQ(all["Ada _ Lovelace"].id, "007");
  EXPECT_EQ(all["Bob, Eve"].id, "8, 9");
}

TEST_F(Intake, a_damaged_list_is_named_with_its_line) {
  add("submission_metadata.yml", "submission_1:\n  - [\n");
  add("submission_1/hit_box.cpp", "a");
  EXPECT_THAT([&] { seen(); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("submission_metadata.yml:")));
}

TEST_F(Intake, a_list_of_another_kind_is_named) {
  add("submission_1/hit_box.cpp", "a");
  for (const char* text :
       {"submissions", "- a", "submission_1: 5", "submission_1:\n  :submitters: x",
        "submission_1:\n  :submitters:\n  - y", "&a [*a]", "!!binary x"}) {
    add(kGradescopeList, text);
    try {
      EXPECT_EQ(seen().size(), 1U) << text;
    } catch (const pt::Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("submission_metadata.yml:")) << text;
    }
  }
}

TEST_F(Intake, archives_in_archives_are_unpacked_to_a_depth) {
  std::string bytes = archive_of({{"hit_box.cpp", "a"}});
  for (int depth = 1; depth <= 6; ++depth) {
    add(std::to_string(depth) + ".zip", bytes);
    bytes = archive_of({{"inner.zip", bytes}});
  }
  auto all = seen();
  for (const char* name : {"1", "2", "3", "4"}) {
    EXPECT_EQ(all[name].files, (Files{{"hit_box.cpp", "a"}})) << name;
  }
  for (const char* name : {"5", "6"}) EXPECT_THAT(all[name].problem, HasSubstr("deep")) << name;
}

TEST_F(Intake, two_archives_and_no_file_cannot_be_chosen_from) {
  add("ada/first.zip", archive_of({{"hit_box.cpp", "1"}}));
  add("ada/second.zip", archive_of({{"hit_box.cpp", "2"}}));
  EXPECT_THAT(seen()["ada"].problem, HasSubstr("2 archives, 'first.zip' and 'second.zip'"));
  add("ada/hit_box.cpp", "3");
  EXPECT_EQ(seen()["ada"].files, (Files{{"hit_box.cpp", "3"}})) << "files beside archives count";
}

TEST_F(Intake, nothing_lands_outside_and_nothing_is_linked) {
  add("evil.zip", archive_of({{"../../evil.cpp", "x"},
                              {"a/../../../evil.cpp", "x"},
                              {"/tmp/firstlight_evil.cpp", "x"},
                              {"..\\..\\evil.cpp", "x"},
                              {"hit_box.cpp", "", AE_IFLNK, "/etc/passwd"},
                              {"link", "", AE_IFLNK, "/tmp"},
                              {"link/firstlight_evil.cpp", "in a folder of its own"},
                              {"hit_sphere.cpp", "first"},
                              {"hit_sphere.cpp", "second"},
                              {"hit_sphere.cpp/inner.cpp", "a file is no folder"}}));
  add("evil.tar.gz",
      archive_of({{"a/../../../evil.cpp", "x"}, {"ok.cpp", "", AE_IFIFO, ""}}, Format::tar_gz));
  fs::create_symlink("/etc", in("linked"));
  auto all = seen();
  EXPECT_EQ(all["evil"].files, (Files{})) << "the tar";
  EXPECT_EQ(all["evil (2)"].files, (Files{{"hit_sphere.cpp", "first"},
                                          {"link/firstlight_evil.cpp", "in a folder of its own"}}));
  EXPECT_THAT(all["linked"].problem, HasSubstr("link"));
  EXPECT_FALSE(fs::exists("/tmp/firstlight_evil.cpp"));
  for (const auto& file : fs::recursive_directory_iterator(folder_.path())) {
    EXPECT_NE(file.path().filename(), "evil.cpp") << file.path();
  }
}

TEST_F(Intake, what_is_broken_or_too_large_has_a_reason_and_the_others_are_there) {
  const std::string good = archive_of({{"hit_box.cpp", std::string(5000, 'a')}, {"b.cpp", "b"}});
  add("cut.zip", good.substr(0, good.size() / 3));
  add("empty.zip", "");
  add("text.zip", "this is no archive");
  std::vector<Entry> bomb;
  for (int i = 0; i < 70; ++i) {
    bomb.push_back({std::to_string(i) + ".cpp", std::string(std::size_t{1} << 20, '\0')});
  }
  add("bomb.zip", archive_of(bomb));
  std::vector<Entry> many;
  for (int i = 0; i < 5001; ++i) many.push_back({std::to_string(i) + ".cpp", ""});
  add("many.zip", archive_of(many));
  add("good.zip", good);
  auto all = seen();
  EXPECT_EQ(all["good"].problem, "");
  for (const char* name : {"cut", "empty", "text", "bomb", "many"}) {
    EXPECT_THAT(all[name].problem, HasSubstr("cannot be unpacked")) << name;
  }
  EXPECT_THAT(all["bomb"].problem, HasSubstr("64 MiB"));
  EXPECT_THAT(all["many"].problem, HasSubstr("5000 files"));
}

TEST_F(Intake, every_cut_and_many_damages_end_with_a_reason_or_files) {
  for (const Format format : {Format::zip, Format::tar_gz}) {
    const std::string good =
        archive_of({{"hit_box.cpp", "int main() { return 0; }"}, {"x/b.cpp", "b"}}, format);
    for (std::size_t i = 0; i < good.size(); ++i) {
      for (const std::string& bytes : {good.substr(0, i), [&] {
                                         std::string other = good;
                                         other[i] = static_cast<char>(other[i] ^ 0x55);
                                         return other;
                                       }()}) {
        pt::write_file(folder_.path() + "/a.zip", bytes);
        const std::string out = folder_.path() + "/out";
        try {
          unpack(folder_.path() + "/a.zip", out);
        } catch (const pt::Error& error) {
          EXPECT_THAT(error.what(), HasSubstr("cannot be unpacked"));
        }
        fs::remove_all(out);
      }
    }
  }
}

TEST_F(Intake, an_empty_class_is_said_to_be_one) {
  EXPECT_THAT([&] { seen(); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("has no submissions in it")));
}

// Names and numbers come from a list that anybody may have written: they become names of reports.
TEST_F(Intake, names_of_a_list_are_names_of_files) {
  const std::string group(300, 'a');
  add("submission_1/hit_box.cpp", "a");
  add("submission_2/hit_box.cpp", "b");
  add("submission_3/hit_box.cpp", "c");
  add("submission_4/hit_box.cpp", "d");
  add(kGradescopeList,
      "submission_1:\n  :submitters:\n  - :name: \"x\\e[31m\\n\\0y\"\n    :sid: \"../../up\"\n"
      "submission_2:\n  :submitters:\n  - :name: \"x\\e[31m\\n\\0y\"\n    :sid: \"../../up\"\n"
      "submission_3:\n  :submitters:\n  - :name: " +
          group +
          "\xc3\xa9\n    :sid: 1\n"
          "submission_4:\n  :submitters:\n  - :name: .\n    :sid: 2\n");
  const auto all = seen();
  EXPECT_EQ(all.size(), 4U);
  for (const auto& [name, one] : all) {
    EXPECT_LE(name.size(), 200U);
    for (const unsigned char c : name) EXPECT_TRUE(c >= 0x20 && c != '/' && c != 0x7f) << name;
    EXPECT_FALSE(name.starts_with('.')) << name;
    EXPECT_EQ(one.files.size(), 1U) << name;
  }
}

// A file that no platform exports is nobody's submission, and the others are judged.
TEST_F(Intake, pipes_and_devices_are_left_out) {
  add("ada/hit_box.cpp", "a");
  ASSERT_EQ(mkfifo(in("bob_1_2_hit_box.cpp").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo(in("carol.zip").c_str(), 0600), 0);
  const auto all = seen();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all.begin()->first, "ada");
}

}  // namespace
}  // namespace grader::intake
