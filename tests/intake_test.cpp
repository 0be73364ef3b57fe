// Exports of learning platforms become one folder per learner; archives are read as data.
#include "grader/base/files.h"
#include "grader/intake/handed_in.h"
#include "grader/intake/unpack.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/temporary_folder.h"

#include <clocale>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace grader::intake {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Entry {
  std::string path, text;
  int type = AE_IFREG;
  std::string points_to{};
};

enum class Format { zip, zip_stored, zip_encrypted, tar_gz, tar_xz, tar_zst, seven_zip };

// The bytes of an archive with these entries, as others' programs make them.
std::string archive_of(const std::vector<Entry>& entries, Format format = Format::zip) {
  std::string bytes(std::size_t{8} << 20, '\0');
  std::size_t used = 0;
  archive* out = archive_write_new();
  if (format == Format::zip || format == Format::zip_stored || format == Format::zip_encrypted) {
    archive_write_set_format_zip(out);
    if (format == Format::zip_stored) archive_write_set_options(out, "zip:compression=store");
    if (format == Format::zip_encrypted) {
      archive_write_set_options(out, "zip:encryption=traditional");
      archive_write_set_passphrase(out, "secret");
    }
  } else if (format == Format::seven_zip) {
    archive_write_set_format_7zip(out);
  } else {
    archive_write_set_format_pax_restricted(out);
    if (format == Format::tar_gz) archive_write_add_filter_gzip(out);
    if (format == Format::tar_xz) archive_write_add_filter_xz(out);
    if (format == Format::tar_zst) archive_write_add_filter_zstd(out);
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

const std::vector<TaskFile> kTasks{{"1_rays", "hit_sphere"},
                                   {"1_rays", "hit_triangle"},
                                   {"1_rays", "hit_box"},
                                   {"2_bvh", "hit_bvh"}};

// Bounds that a small archive exceeds. An archive of everybody's work has the usual ones.
const Limits kSmall{{1000, 20, std::uint64_t{2} << 20, kBoundsOfOne.unpacked}, kBoundsOfEverybody};

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
    Platform platform = Platform::none;
    std::string feedback{};
    std::map<std::string, std::string> files{};
    std::map<std::string, std::string> judged{};  // what the judge reads, by task
  };
  std::map<std::string, Seen> seen(const fs::path& input) const {
    const auto unpack_here = [this](const std::string& archive, const std::string& folder,
                                    Extent extent) {
      try {
        unpack(archive, folder, extent, limits_);
        return std::string();
      } catch (const pt::Error& error) {
        return std::string(error.what());
      }
    };
    std::map<std::string, Seen> all;
    const HandedInByAll handed = handed_in(input, folder_.path() + "/work", kTasks, unpack_here);
    unclaimed_ = handed.unclaimed;
    for (const HandedIn& each : handed.everybody) {
      Seen one{each.id, each.problem, each.late, each.platform, each.feedback};
      if (each.problem.empty() && fs::exists(each.folder)) {
        for (const auto& file : fs::recursive_directory_iterator(each.folder)) {
          if (file.path().extension() != ".cpp" || file.is_symlink()) continue;
          one.files[fs::relative(file.path(), each.folder)] = pt::read_file(file.path(), 10000);
        }
      }
      for (const TaskFile& task : kTasks) {
        if (!each.problem.empty()) break;
        const std::string root = base::submission_root(each.folder);
        const base::Submitted read = base::read_submitted(root, task.part, task.slug);
        if (read.present) one.judged[task.slug] = read.text;
      }
      EXPECT_TRUE(all.emplace(each.name, one).second) << each.name << " twice";
    }
    return all;
  }
  std::map<std::string, Seen> seen() const { return seen(in()); }

  TemporaryFolder folder_;
  Limits limits_;
  mutable std::vector<std::string> unclaimed_;  // of the last call
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
  EXPECT_EQ(all["bob"].files, (Files{{"student/1_rays/hit_box.cpp", "b"}}));
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

TEST_F(Intake, an_entry_of_the_list_that_is_damaged_costs_its_names_only) {
  add("submission_1/hit_box.cpp", "a");
  add("submission_2/hit_box.cpp", "b");
  for (const char* entry : {"5", "[1, 2]", "~", "{:submitters: x}", "{:submitters: {:name: Bob}}",
                            "{:submitters: [y, [z]]}", "{:submitters: [{:name: [Bob]}]}", "{}"}) {
    add(kGradescopeList,
        fmt::format("submission_1: {}\nsubmission_2: {{:submitters: [{{:name: Ada}}]}}\n", entry));
    auto all = seen();
    EXPECT_EQ(all.size(), 2U) << entry;
    EXPECT_EQ(all["submission_1"].files, (Files{{"hit_box.cpp", "a"}})) << entry;
    EXPECT_EQ(all["Ada"].files, (Files{{"hit_box.cpp", "b"}})) << entry;
  }
}

TEST_F(Intake, a_submission_that_is_hidden_is_named) {
  add("ada/hit_box.cpp", "a");
  add(".bob/1_rays/hit_box.cpp", "b");
  add(".cy.zip", archive_of({{"hit_box.cpp", "c"}}));
  add(".git/HEAD", "?");
  add("__MACOSX/._ada/._hit_box.cpp", "?");
  EXPECT_EQ(seen().size(), 1U);
  EXPECT_THAT(unclaimed_, testing::ElementsAre(".bob", ".cy.zip"));
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
  add("bob/hit_box.cpp", "b");
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
  Files& files = all["evil (2)"].files;
  EXPECT_EQ(files.size(), 3U);
  EXPECT_EQ(files["hit_sphere.cpp"], "second");
  EXPECT_EQ(files["link/firstlight_evil.cpp"], "in a folder of its own");
  EXPECT_THAT(files["hit_box.cpp"], testing::StartsWith("#error \"in the archive"));
  EXPECT_THAT(all["linked"].problem, HasSubstr("link"));
  EXPECT_FALSE(fs::exists("/tmp/firstlight_evil.cpp"));
  for (const auto& file : fs::recursive_directory_iterator(folder_.path())) {
    EXPECT_NE(file.path().filename(), "evil.cpp") << file.path();
  }
}

TEST_F(Intake, what_is_broken_or_too_large_has_a_reason_and_the_others_are_there) {
  limits_ = kSmall;
  const std::string good = archive_of({{"hit_box.cpp", std::string(5000, 'a')}, {"b.cpp", "b"}});
  add("cut.zip", good.substr(0, good.size() / 3));
  add("empty.zip", "");
  add("text.zip", "this is no archive");
  std::vector<Entry> bomb;
  for (int i = 0; i < 3; ++i) {
    bomb.push_back({std::to_string(i) + ".cpp", std::string(std::size_t{1} << 20, '\0')});
  }
  add("bomb.zip", archive_of(bomb));
  std::vector<Entry> many;
  for (int i = 0; i < 21; ++i) many.push_back({std::to_string(i) + ".cpp", ""});
  add("many.zip", archive_of(many));
  add("good.zip", good);
  auto all = seen();
  EXPECT_EQ(all["good"].problem, "");
  for (const char* name : {"cut", "empty", "text", "bomb", "many"}) {
    EXPECT_THAT(all[name].problem, HasSubstr("cannot be unpacked")) << name;
  }
  EXPECT_THAT(all["bomb"].problem, HasSubstr("larger than 2 MiB"));
  EXPECT_THAT(all["many"].problem, HasSubstr("more than 20 files"));
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
TEST_F(Intake, what_is_left_out_is_said) {
  add("absolute.zip", archive_of({{"/home/ada/hit_box.cpp", "a"}}));
  add("parent.zip", archive_of({{"../hit_box.cpp", "a"}, {"a/..\\hit_sphere.cpp", "a"}}));
  add("both.zip", archive_of({{"../hit_box.cpp", "a"}, {"hit_sphere.cpp", "b"}}));
  add("hidden.zip", archive_of({{".a/hit_box.cpp", "a"}}));
  add("link.tar.gz", archive_of({{"hit_box.cpp", "", AE_IFLNK, "/etc/passwd"},
                                 {"hit_sphere.cpp", "s"},
                                 {"notes", "", AE_IFLNK, "/tmp"}},
                                Format::tar_gz));
  add("links.zip", archive_of({{"hit_box.cpp", "", AE_IFLNK, "/etc/passwd"}, {"notes.txt", "n"}}));
  fs::create_directories(in("linked"));
  fs::create_directory_symlink("/etc", in("linked/student"));
  auto all = seen();
  for (const char* name : {"absolute", "parent"}) {
    EXPECT_THAT(all[name].problem, HasSubstr("its paths are absolute or lead out of it"));
  }
  EXPECT_EQ(all["both"].files, (Files{{"hit_sphere.cpp", "b"}}));
  EXPECT_THAT(all["hidden"].problem, HasSubstr("it is empty"));
  EXPECT_THAT(all["link"].judged["hit_box"], HasSubstr("this is a link or a device"));
  EXPECT_EQ(all["link"].files.size(), 2U);
  EXPECT_THAT(all["links"].problem, HasSubstr("its source files are links"));
  EXPECT_THAT(all["linked"].problem, testing::EndsWith("only 'student' (a link)"));
}

TEST_F(Intake, pipes_and_devices_are_nobodys) {
  add("ada/hit_box.cpp", "a");
  ASSERT_EQ(mkfifo(in("bob_1_2_hit_box.cpp").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo(in("carol.zip").c_str(), 0600), 0);
  const auto all = seen();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all.begin()->first, "ada");
  EXPECT_EQ(unclaimed_, (std::vector<std::string>{"bob_1_2_hit_box.cpp", "carol.zip"}));
}

// A class as Canvas and Moodle pack it: the bounds of one learner are not those of all.
TEST_F(Intake, the_archive_of_a_class_has_the_bounds_of_a_class) {
  limits_ = kSmall;
  std::vector<Entry> entries;
  for (int learner = 0; learner < 30; ++learner) {
    for (int file = 0; file < 3; ++file) {
      const std::string name = file == 0 ? "hit_box" : "other_" + std::to_string(file);
      entries.push_back(
          {fmt::format("class/learner_{}_{}_{}.cpp", learner, learner * 3 + file, name),
           std::to_string(learner)});
    }
  }
  pt::write_file(in("class.zip"), archive_of(entries));
  auto all = seen(in("class.zip"));
  EXPECT_EQ(all.size(), 30U);
  EXPECT_EQ(all["learner (17)"].files["hit_box.cpp"], "17");
  limits_.everybody.files = 89;
  EXPECT_THAT([&] { seen(in("class.zip")); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("more than 89 files")));
  limits_.everybody = kBoundsOfEverybody;
  limits_.everybody.entries = 89;
  EXPECT_THAT([&] { seen(in("class.zip")); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("more than 89 entries")));
}

TEST_F(Intake, a_thousand_learners_are_within_the_bounds) {
  const Limits usual;
  EXPECT_GE(usual.everybody.files, 12 * 1000);
  EXPECT_GE(usual.everybody.entries, usual.everybody.files);
  EXPECT_GE(usual.everybody.bytes, 20 * usual.one.bytes);
  EXPECT_EQ(usual.one.files, 5000);
  EXPECT_EQ(usual.one.bytes, std::uint64_t{64} << 20);
}

TEST_F(Intake, each_owner_in_the_archive_of_a_class_has_the_bounds_of_one) {
  limits_ = kSmall;
  std::vector<Entry> entries{{"ada/hit_box.cpp", "a"}};
  for (int i = 0; i < 21; ++i) entries.push_back({fmt::format("bob/{}.cpp", i), ""});
  entries.push_back({"cy/hit_box.cpp", "c"});
  for (int i = 0; i < 3; ++i) {
    entries.push_back({fmt::format("di/{}.cpp", i), std::string(std::size_t{1} << 20, '\0')});
  }
  entries.push_back({"eve/hit_box.cpp", "e"});
  pt::write_file(in("class.zip"), archive_of(entries));
  auto all = seen(in("class.zip"));
  EXPECT_EQ(all.size(), 5U);
  EXPECT_THAT(all["bob"].problem, HasSubstr("more than 20 files"));
  EXPECT_THAT(all["di"].problem, HasSubstr("larger than 2 MiB"));
  for (const char* name : {"ada", "cy", "eve"}) {
    EXPECT_EQ(all[name].problem, "") << name;
    EXPECT_EQ(all[name].files.size(), 1U) << name;
  }
}

TEST_F(Intake, everybody_in_the_archive_of_a_class_has_a_row) {
  pt::write_file(in("class.tar.gz"), archive_of({{"ada/hit_box.cpp", "a"},
                                                 {"bob/work.gz", "?"},
                                                 {"cy/report.pdf", "?"},
                                                 {"di/hit_box.CPP", "d"},
                                                 {"eve/onlinetext.html", "?"},
                                                 {"fay", "", AE_IFDIR},
                                                 {"gus", "", AE_IFLNK, "/etc"},
                                                 {"hal/hit_box.cpp", "", AE_IFLNK, "/etc/passwd"},
                                                 {"ida.gz", "?"},
                                                 {"jo\xc3\xab/.DS_Store", "?"},
                                                 {"jo\xc3\xab/__MACOSX/._hit_box.cpp", "?"},
                                                 {"__MACOSX/ada/._hit_box.cpp", "?"},
                                                 {".DS_Store", "?"}},
                                                Format::tar_gz));
  auto all = seen(in("class.tar.gz"));
  EXPECT_EQ(all.size(), 10U);
  EXPECT_EQ(all["ada"].problem, "");
  EXPECT_THAT(all["bob"].problem, HasSubstr("only 'work.gz'"));
  EXPECT_THAT(all["bob"].problem, HasSubstr("hand in a zip"));
  EXPECT_THAT(all["cy"].problem, HasSubstr("only 'report.pdf'"));
  EXPECT_EQ(all["di"].files, (Files{{"1_rays/hit_box.cpp", "d"}}));
  EXPECT_THAT(all["eve"].problem, HasSubstr("only 'onlinetext.html'"));
  EXPECT_THAT(all["fay"].problem, HasSubstr("it is empty"));
  EXPECT_THAT(all["gus"].problem, HasSubstr("link"));
  EXPECT_THAT(all["hal"].problem, HasSubstr("its source files are links"));
  EXPECT_THAT(all["ida"].problem, HasSubstr("hand in a zip"));
  EXPECT_THAT(all["jo\xc3\xab"].problem, HasSubstr("it is empty")) << "hidden files only";
}

TEST_F(Intake, files_on_top_have_an_owner_or_are_named) {
  add("bob.gz", "?");
  add("cy.tar.zst", archive_of({{"hit_box.cpp", "c"}}, Format::tar_zst));
  add("di.cpp", "?");
  add("notes.txt", "?");
  add("12-34 - Fay Ace - Jan 15, 2027 1005 PM - hit_sphere.cpp", "new");
  add("12-34 - Fay Ace - Jan 15, 2027 905 PM - hit_sphere.cpp", "old");
  add("12-34 - Fay Ace - Jan 15, 2027 905 AM - hit_box.cpp", "b");
  add("hw 1_gus_attempt_2027-01-15-22-05-33_hit_sphere.cpp", "g");
  add("hw 1_gus_attempt_2027-01-14-22-05-33_hit_sphere.cpp", "old");
  add("hw 1_gus_attempt_2027-01-15-22-05-33.txt", "?");
  auto all = seen();
  EXPECT_EQ(all.size(), 4U);
  EXPECT_THAT(all["bob"].problem, HasSubstr("hand in a zip"));
  EXPECT_EQ(all["cy"].files, (Files{{"hit_box.cpp", "c"}}));
  EXPECT_EQ(all["Fay Ace"].files, (Files{{"hit_sphere.cpp", "new"}, {"hit_box.cpp", "b"}}));
  EXPECT_EQ(all["Fay Ace"].id, "12-34");
  EXPECT_EQ(all["gus"].files, (Files{{"hit_sphere.cpp", "g"}}));
  EXPECT_THAT(unclaimed_, testing::ElementsAre("di.cpp", "notes.txt"));
}

TEST_F(Intake, canvas_may_hide_names) {
  add("anon_aB3xz_901_hit_box.cpp", "a");
  add("anon_aB3xz_902_hit_sphere.cpp", "s");
  add("LATE_anon_qqqqq_903_hit_box.cpp", "q");
  auto all = seen();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all["anon_aB3xz"].files, (Files{{"hit_box.cpp", "a"}, {"hit_sphere.cpp", "s"}}));
  EXPECT_TRUE(all["anon_qqqqq"].late);
}

TEST_F(Intake, moodle_without_folders_is_one_row_per_participant) {
  add("Ada L_1_assignsubmission_file_hit_sphere.cpp", "s");
  add("Ada L_1_assignsubmission_file_hit_box.cpp", "b");
  add("Bob_2_assignsubmission_file_work.zip", archive_of({{"hit_box.cpp", "z"}}));
  add("Cy_3_assignsubmission_file_/hit_box.cpp", "c");
  add("Cy_3_assignsubmission_onlinetext_/onlinetext.html", "?");
  add("Di_4_assignsubmission_onlinetext_/onlinetext.html", "?");
  auto all = seen();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all["Ada L"].files, (Files{{"hit_sphere.cpp", "s"}, {"hit_box.cpp", "b"}}));
  EXPECT_EQ(all["Ada L"].id, "1");
  EXPECT_EQ(all["Bob"].files, (Files{{"hit_box.cpp", "z"}}));
  EXPECT_EQ(all["Bob"].platform, Platform::moodle);
  EXPECT_EQ(all["Cy"].files, (Files{{"hit_box.cpp", "c"}}));
  EXPECT_EQ(all["Cy"].feedback, "Cy_3_assignsubmission_file_/report.html");
  EXPECT_THAT(all["Di"].problem, HasSubstr("only 'onlinetext.html'"));
}

TEST_F(Intake, folders_around_everything_are_entered) {
  add("export/handed in/ada/hit_box.cpp", "a");
  add("export/handed in/bob/student/1_rays/hit_box.cpp", "b");
  EXPECT_EQ(seen().size(), 2U);
}

// An example of what to hand in, or the class being a repository, does not make all of it one submission.
TEST_F(Intake, a_task_file_beside_the_learners_does_not_hide_them) {
  add("export/hit_box.cpp", "?");
  add("export/.git/HEAD", "?");
  add("export/ada/hit_box.cpp", "a");
  add("export/bob.zip", archive_of({{"hit_box.cpp", "b"}}));
  EXPECT_EQ(seen().size(), 2U);
  EXPECT_EQ(unclaimed_, (std::vector<std::string>{"hit_box.cpp"}));
  // A learner's folder may have one more.
  fs::remove_all(in("export"));
  add("ada/hit_box.cpp", "a");
  add("ada/1_rays/hit_sphere.cpp", "a");
  add("ada/2_bvh/hit_bvh.cpp", "a");
  add("ada/old/1_rays/hit_box.cpp", "old");
  EXPECT_EQ(seen().size(), 1U);
}

TEST_F(Intake, the_folder_of_one_learner_is_not_entered) {
  add("ada/1_rays/hit_box.cpp", "a");
  add("ada/notes.txt", "?");
  EXPECT_EQ(seen()["ada"].files, (Files{{"1_rays/hit_box.cpp", "a"}}));
  EXPECT_EQ(seen().size(), 1U);
}

// The bytes of an archive in which those after a text are others.
std::string damaged(std::string bytes, const std::string& after, std::size_t from, std::size_t to) {
  const std::size_t at = bytes.find(after) + after.size();
  for (std::size_t i = at + from; i < at + to; ++i) bytes[i] = static_cast<char>(~bytes[i]);
  return bytes;
}

// Text that does not become much smaller.
std::string any_text(std::size_t size) {
  std::string text;
  for (unsigned state = 1; text.size() < size; state = state * 1664525U + 1013904223U) {
    text += static_cast<char>(' ' + (state >> 25) % 90);
  }
  return text;
}

std::string bytes_of(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

TEST_F(Intake, a_bad_entry_in_the_archive_of_a_class_is_its_owners) {
  const std::vector<Entry> entries{{"ada/hit_box.cpp", any_text(3000)},
                                   {"bob/hit_box.cpp", any_text(3000)},
                                   {"cy/hit_box.cpp", "c"}};
  for (const Format format : {Format::zip, Format::zip_stored}) {
    const std::string bytes = archive_of(entries, format);
    // The first of the two places of the name is in front of the data.
    pt::write_file(in("class.zip"), damaged(bytes, "bob/hit_box.cpp", 500, 700));
    auto all = seen(in("class.zip"));
    EXPECT_EQ(all.size(), 3U);
    EXPECT_EQ(all["ada"].files.size(), 1U) << all["ada"].problem;
    EXPECT_THAT(all["bob"].problem, HasSubstr("'hit_box.cpp' cannot be unpacked"));
    EXPECT_EQ(all["cy"].files, (Files{{"hit_box.cpp", "c"}}));
    pt::write_file(in("class.zip"), bytes.substr(0, bytes.size() / 2));
    EXPECT_THAT([&] { seen(in("class.zip")); },
                testing::ThrowsMessage<pt::Error>(HasSubstr("cannot be unpacked")))
        << "the archive ends";
  }
}

// An archive with an entry that zlib cannot read on; libarchive's reader ends there.
std::string with_ends(std::string bytes, const std::string& name) {
  for (std::size_t at = 0; (at = bytes.find("PK\3\4", at)) != bytes.npos; ++at) {
    const auto size = [&](std::size_t place) {
      return static_cast<unsigned char>(bytes[at + place]) +
             256U * static_cast<unsigned char>(bytes[at + place + 1]);
    };
    if (bytes.compare(at + 30, name.size(), name) != 0) continue;
    bytes[at + 30 + size(26) + size(28)] = 7;  // a block of a kind that there is not
  }
  return bytes;
}

TEST_F(Intake, an_entry_that_ends_the_reader_is_its_owners_up_to_a_number) {
  std::vector<Entry> entries{{"ada/hit_box.cpp", any_text(300)}};
  for (int i = 0; i < 200; ++i) entries.push_back({fmt::format("bob/{}.cpp", i), any_text(300)});
  entries.push_back({"cy/hit_box.cpp", "c"});
  pt::write_file(in("class.zip"), with_ends(archive_of(entries), "bob/1.cpp"));
  auto all = seen(in("class.zip"));
  EXPECT_THAT(all["bob"].problem, HasSubstr("'1.cpp' cannot be unpacked"));
  EXPECT_EQ(all["ada"].files.size(), 1U);
  EXPECT_EQ(all["cy"].files, (Files{{"hit_box.cpp", "c"}}));
  for (int i = 0; i < 201; ++i) entries.push_back({fmt::format("z{}/a.cpp", i), any_text(300)});
  pt::write_file(in("class.zip"), with_ends(archive_of(entries), "z"));
  EXPECT_THAT([&] { seen(in("class.zip")); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("damaged in many places")));
}

TEST_F(Intake, all_that_is_read_counts_also_what_is_left_out) {
  pt::write_file(in("class.tar.gz"), archive_of({{"ada/hit_box.cpp", any_text(3000)},
                                                 {"ada/film.mov", std::string(100'000, '\0')},
                                                 {"bob/hit_box.cpp", "b"}},
                                                Format::tar_gz));
  EXPECT_EQ(seen(in("class.tar.gz")).size(), 2U);
  limits_.everybody.unpacked = 50'000;
  EXPECT_THAT([&] { seen(in("class.tar.gz")); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("it is larger than")));
  limits_.everybody = kBoundsOfEverybody;
  limits_.everybody.bytes = 3000;
  EXPECT_THAT([&] { seen(in("class.tar.gz")); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("its files are larger than")));
}

TEST_F(Intake, an_encrypted_entry_is_its_owners) {
  std::string bytes = archive_of({{"ada/hit_box.cpp", "a"}, {"bob/hit_box.cpp", "b"}});
  // The bit of encryption, in front of the file and in the directory at the end: 24 and 38 bytes before the name.
  const std::size_t first = bytes.find("bob/"), last = bytes.rfind("bob/");
  bytes[first - 24] |= 1;
  bytes[last - 38] |= 1;
  pt::write_file(in("class.zip"), bytes);
  auto all = seen(in("class.zip"));
  EXPECT_EQ(all["ada"].files, (Files{{"hit_box.cpp", "a"}}));
  EXPECT_THAT(all["bob"].problem, HasSubstr("encrypted"));
}

TEST_F(Intake, long_names_are_cut_before_their_ending) {
  const std::string name(300, 'a');
  pt::write_file(in("class.zip"),
                 archive_of({{"bob/hit_box.cpp", "b"},
                             {"cy_1_2_" + name + ".zip", archive_of({{"hit_box.cpp", "c"}})}}));
  auto all = seen(in("class.zip"));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all["cy"].files, (Files{{"hit_box.cpp", "c"}})) << all["cy"].problem;
}

TEST_F(Intake, usual_compressions_are_unpacked) {
  const std::vector<Entry> entries{{"hit_box.cpp", "a"}};
  add("xz.tar.xz", archive_of(entries, Format::tar_xz));
  add("seven.7z", archive_of(entries, Format::seven_zip));
  add("locked.zip", archive_of(entries, Format::zip_encrypted));
  // A RAR 4 archive of hit_box.cpp with the text "int x;\n", not compressed.
  add("rar.rar",
      bytes_of("526172211a0700cf907300000d00000000000000e1437400802b000700000007000000039d6e599b000"
               "0215a14300b00a48100006869745f626f782e637070696e7420783b0ac43d7b00400700"));
  auto all = seen();
  EXPECT_EQ(all["xz"].files, (Files{{"hit_box.cpp", "a"}}));
  EXPECT_EQ(all["seven"].files, (Files{{"hit_box.cpp", "a"}}));
  EXPECT_EQ(all["rar"].files, (Files{{"hit_box.cpp", "int x;\n"}})) << all["rar"].problem;
  EXPECT_THAT(all["locked"].problem, HasSubstr("encrypted"));
}

TEST_F(Intake, what_cannot_be_read_is_one_problem) {
  if (geteuid() == 0) GTEST_SKIP() << "root reads everything";
  add("ada/hit_box.cpp", "a");
  add("bob/1_rays/hit_box.cpp", "b");
  add("cy_7_8_hit_box.cpp", "c");
  fs::permissions(in("bob/1_rays"), fs::perms::none);
  fs::permissions(in("cy_7_8_hit_box.cpp"), fs::perms::none);
  auto all = seen();
  fs::permissions(in("bob/1_rays"), fs::perms::owner_all);
  EXPECT_EQ(all.size(), 3U);
  EXPECT_EQ(all["ada"].problem, "");
  EXPECT_THAT(all["bob"].problem, HasSubstr("'1_rays' cannot be read"));
  EXPECT_THAT(all["cy"].problem, HasSubstr("cannot be read"));
}

TEST_F(Intake, files_with_two_numbers_need_not_be_of_canvas) {
  const std::string work = archive_of({{"hit_box.cpp", "a"}});
  add("hw_2027_1_ada.zip", work);
  add("hw_2027_1_bob.zip", work);
  EXPECT_EQ(seen().size(), 2U) << "a number of a file twice";
  EXPECT_EQ(seen()["hw_2027_1_ada"].files, (Files{{"hit_box.cpp", "a"}}));
  fs::remove_all(in());
  add("ada_2027_1_hw.zip", work);
  add("bob_2027_2_hw.zip", work);
  EXPECT_EQ(seen()["bob_2027_2_hw"].files, (Files{{"hit_box.cpp", "a"}})) << "an ID of two";
}

TEST_F(Intake, who_is_on_gradescopes_list_has_a_row) {
  add("submission_1/hit_box.cpp", "a");
  add("submission_3/hit_box.cpp", "c");
  add(kGradescopeList,
      "submission_1:\n  :submitters:\n  - :name: Ada\n    :sid:\n    :email: ada@x.org\n"
      "submission_2:\n  :submitters:\n  - :name: Bob\n    :sid: 8\n");
  auto all = seen();
  EXPECT_EQ(all.size(), 3U);
  EXPECT_EQ(all["Ada"].id, "ada@x.org");
  EXPECT_THAT(all["Bob"].problem, HasSubstr("no folder"));
  EXPECT_EQ(all["submission_3"].files, (Files{{"hit_box.cpp", "c"}}));
}

TEST_F(Intake, canvas_numbers_archives_and_equal_names) {
  add("ada_1_901_part-1.zip", archive_of({{"hit_box.cpp", "1"}}));
  add("ada_1_902_part-2.zip", archive_of({{"hit_sphere.cpp", "2"}}));
  add("bob_2_904_hit_box.cpp", "last");
  add("bob_2_99_hit_box.cpp", "first");
  auto all = seen();
  EXPECT_THAT(all["ada"].problem, HasSubstr("holds 2 archives"));
  EXPECT_EQ(all["bob"].files, (Files{{"hit_box.cpp", "last"}}));
}

TEST_F(Intake, task_files_are_found_however_deep) {
  const std::map<std::string, std::vector<Entry>> packed{
      {"src", {{"README.md", "r"}, {"src/1_rays/hit_box.cpp", "s"}}},
      {"include", {{"src/hit_box.cpp", "s"}, {"include/a.h", "h"}}},
      {"clone",
       {{"README.md", "r"},
        {"firstlight/pt/a.h", "h"},
        {"firstlight/grader/mistakes/hit_box.cpp", "not this"},
        {"firstlight/student/1_rays/hit_box.cpp", "s"}}},
      {"stray", {{"main.cpp", "m"}, {"work.zip", archive_of({{"hit_box.cpp", "s"}})}}},
      {"both", {{"hit_box.cpp", "s"}, {"old/hit_box.cpp", "not this"}}},
      {"two", {{"a/hit_box.cpp", "s"}, {"b/hit_box.cpp", "t"}}}};
  for (const bool as_zip : {true, false}) {
    fs::remove_all(in());
    for (const auto& [name, entries] : packed) {
      if (as_zip) add(name + ".zip", archive_of(entries));
      for (const Entry& each : entries) {
        if (!as_zip) add(name + "/" + each.path, each.text);
      }
    }
    auto all = seen();
    for (const char* name : {"src", "include", "clone", "stray", "both"}) {
      EXPECT_EQ(all[name].judged, (Files{{"hit_box", "s"}})) << name << all[name].problem;
    }
    EXPECT_THAT(all["two"].problem, HasSubstr("'a/hit_box.cpp' and 'b/hit_box.cpp'"));
  }
}

TEST_F(Intake, files_that_are_nearly_named_right_count) {
  add("ada/hit_sphere-1.cpp", "s");
  add("ada/Hit_Box.CPP", "b");
  add("ada/hit_triangle (1).cpp", "t");
  add("ada/2_bvh/hit_bvh.cpp.txt", "v");
  add("bob/hit_box (1).cpp", "1");
  add("bob/hit_box (2).cpp", "2");
  add("cy/hit_box.cpp", "right");
  add("cy/hit_box-1.cpp", "left");
  auto all = seen();
  EXPECT_EQ(all["ada"].files, (Files{{"1_rays/hit_sphere.cpp", "s"},
                                     {"1_rays/hit_box.cpp", "b"},
                                     {"1_rays/hit_triangle.cpp", "t"},
                                     {"2_bvh/hit_bvh.cpp", "v"}}));
  EXPECT_THAT(all["bob"].problem, HasSubstr("'hit_box (1).cpp' and 'hit_box (2).cpp' may both be"));
  EXPECT_EQ(all["cy"].files["hit_box.cpp"], "right");
}

TEST_F(Intake, names_are_those_of_reports) {
  for (const char* name : {"class", "Plan", "Zo\xc3\xab", "zo\xc3\x8b",
                           "a\xe2\x80\xae"
                           "b",
                           "c\xc2\x9b"
                           "d",
                           "e\xff"
                           "f"}) {
    add(std::string(name) + "/hit_box.cpp", "a");
  }
  add("gus.zip", archive_of({{"hit_box.cpp", "z"}}));
  add("gus.tar.gz", archive_of({{"hit_box.cpp", "t"}}, Format::tar_gz));
  auto all = seen();
  EXPECT_EQ(all.size(), 9U);
  for (const char* name : {"class (2)", "Plan (2)", "a_b", "c_d", "e_f", "gus", "gus (2)"}) {
    EXPECT_TRUE(all.contains(name)) << name;
  }
  EXPECT_TRUE(all.contains("Zo\xc3\xab (2)") || all.contains("zo\xc3\x8b (2)"));
  EXPECT_EQ(all["gus"].feedback, "gus.html");
  EXPECT_EQ(all["gus (2)"].feedback, "gus (2).html");
}

// A name as a learner's computer writes it, and as a platform does.
const char* const kComposed = "Zo\xc3\xab";
const char* const kWithMarks = "Zoe\xcc\x88";

TEST_F(Intake, names_that_differ_in_accents_as_bytes_only_are_two) {
  for (const std::string& name : {std::string(kComposed), std::string(kWithMarks)}) {
    add(name + "/hit_box.cpp", name);
    add(name + " K_7_assignsubmission_file_/hit_box.cpp", name + " K");
  }
  add("Zo\xc3\xa9/hit_box.cpp", "another accent");
  add("zOE\xcc\x88/hit_box.cpp", "capital");
  // Hangul, and Japanese.
  for (const char* name : {"\xea\xb0\x81", "\xe1\x84\x80\xe1\x85\xa1\xe1\x86\xa8", "\xe3\x81\x8c",
                           "\xe3\x81\x8b\xe3\x82\x99"}) {
    add(std::string(name) + "/hit_box.cpp", name);
  }
  auto all = seen();
  EXPECT_EQ(all.size(), 10U);
  for (const std::string name : {kComposed, "Zo\xc3\xab K", "\xea\xb0\x81", "\xe3\x81\x8c"}) {
    EXPECT_EQ(all[name].files, (Files{{"hit_box.cpp", name}}));
  }
  EXPECT_EQ(all["Zo\xc3\xa9"].files.size(), 1U) << "it needs no number";
  EXPECT_EQ(all["Zoe\xcc\x88 (2)"].files, (Files{{"hit_box.cpp", kWithMarks}}));
  EXPECT_EQ(all["zOE\xcc\x88 (3)"].files, (Files{{"hit_box.cpp", "capital"}}));
  for (const char* name : {"Zoe\xcc\x88 K (2)", "\xe1\x84\x80\xe1\x85\xa1\xe1\x86\xa8 (2)",
                           "\xe3\x81\x8b\xe3\x82\x99 (2)"}) {
    EXPECT_EQ(all[name].files.size(), 1U) << name;
  }
}

TEST_F(Intake, nobody_is_lost_where_an_archive_writes_accents_in_two_ways) {
  for (const Format format : {Format::zip, Format::tar_gz}) {
    pt::write_file(in("class.zip"), archive_of({{std::string(kComposed) + "/hit_box.cpp", "1"},
                                                {std::string(kWithMarks) + "/hit_box.cpp", "2"},
                                                {"ada/hit_box.cpp", "a"},
                                                {"Ada/hit_box.cpp", "A"},
                                                {"bob/hit_box.cpp", "b"},
                                                {"bob/hit_box.cpp", "b"}},
                                               format));
    auto all = seen(in("class.zip"));
    EXPECT_THAT(all[kComposed].problem, HasSubstr("unpack the archive, and grade the folder"));
    for (const auto& [name, text] : {std::pair("Ada", "A"), {"ada (2)", "a"}, {"bob", "b"}}) {
      EXPECT_EQ(all[name].files, (Files{{"hit_box.cpp", text}})) << name;
    }
    EXPECT_EQ(all.size(), 4U);
  }
}

// Nor where their folders have no file in common, or their archives are equal.
TEST_F(Intake, names_that_become_one_in_an_archive_are_a_row_with_the_reason) {
  const std::string one = kComposed, two = kWithMarks;
  const std::vector<Entry> files{
      {one + "/hit_box.cpp", "1"},        {"ada/hit_box.cpp", "a"},
      {"ada/hit_sphere.cpp", "a"},        {"Zo\xc3\xa9/hit_box.cpp", "e"},
      {"Zo\xc3\xa9/hit_sphere.cpp", "e"}, {two + "/hit_sphere.cpp", "2"}};
  std::vector<Entry> with_folders;
  for (const std::string& name : {one, two, std::string("ada"), std::string("Zo\xc3\xa9")}) {
    with_folders.push_back({name + "/", "", AE_IFDIR});
  }
  with_folders.insert(with_folders.end(), files.begin(), files.end());
  const std::string packed = archive_of({{"hit_box.cpp", "1"}});
  const std::vector<Entry> archives{{one + ".zip", packed},
                                    {two + ".zip", packed},
                                    {"ada.zip", packed},
                                    {"Zo\xc3\xa9.zip", packed}};
  for (const Format format : {Format::zip, Format::tar_gz}) {
    for (const std::vector<Entry>& entries : {files, with_folders, archives}) {
      SCOPED_TRACE(fmt::format("format {}, first {}", static_cast<int>(format), entries[0].path));
      pt::write_file(in("class.zip"), archive_of(entries, format));
      auto all = seen(in("class.zip"));
      EXPECT_THAT(all[one].problem, HasSubstr("unpack the archive, and grade the folder"));
      for (const std::string name : {"ada", "Zo\xc3\xa9"}) {
        EXPECT_EQ(all[name].problem, "");
        EXPECT_FALSE(all[name].files.empty());
      }
      EXPECT_EQ(all.size(), 3U);
    }
  }
  // The number of a platform tells that it is one learner, and in large and small letters a name is its own.
  pt::write_file(in("class.zip"),
                 archive_of({{one + "_7_assignsubmission_file_/hit_box.cpp", "1"},
                             {"ada/hit_box.cpp", "a"},
                             {"bob/hit_box.cpp", "b"},
                             {"ada/hit_sphere.cpp", "a"},
                             {one + "_7_assignsubmission_file_/hit_sphere.cpp", "1"}}));
  for (const auto& [name, found] : seen(in("class.zip"))) EXPECT_EQ(found.problem, "") << name;
}

TEST_F(Intake, progress_counts_submissions) {
  using Told = std::vector<std::pair<std::size_t, std::size_t>>;
  const auto told = [&](const fs::path& input) {
    Told all;
    handed_in(
        input, folder_.path() + "/work", kTasks,
        [](const std::string&, const std::string&, Extent) { return "not now"; },
        [&](std::size_t done, std::size_t of) { all.emplace_back(done, of); });
    return all;
  };
  // Two files of one learner are one submission.
  add("ada_1_11_hit_box.cpp", "a");
  add("ada_1_12_hit_sphere.cpp", "a");
  add("bob_2_13_work.zip", "b");
  add("eve/hit_box.cpp", "e");
  EXPECT_EQ(told(in()), (Told{{0, 3}, {1, 3}, {2, 3}, {3, 3}}));
  fs::remove_all(in());
  add("submission_metadata.yml", "submission_1:\n  :submitters:\n  - :name: Ada\n");
  add("submission_1/hit_box.cpp", "a");
  add("submission_2/hit_box.cpp", "b");
  EXPECT_EQ(told(in()), (Told{{0, 2}, {1, 2}, {2, 2}}));
}

TEST_F(Intake, a_bare_repository_is_named) {
  add("ada/HEAD", "ref: refs/heads/main");
  fs::create_directories(in("ada/objects"));
  fs::create_directories(in("ada/refs"));
  EXPECT_THAT(seen()["ada"].problem, HasSubstr("git repository"));
}

// Nobody's verdict hangs on a full disk.
TEST_F(Intake, faults_of_the_machine_are_nobodys) {
  add("ada.zip", archive_of({{"hit_box.cpp", "a"}}));
  const auto full = [](const std::string&, const std::string&, Extent) -> std::string {
    throw pt::Error("the disk is full");
  };
  EXPECT_THAT([&] { handed_in(in(), folder_.path() + "/work", kTasks, full); },
              testing::ThrowsMessage<pt::Error>("the disk is full"));
}

}  // namespace
}  // namespace grader::intake
