// Every name is fit for a report, and two learners have two names.
#include "pt/file.h"
#include "tests/grader/service/intake/intake.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <archive_entry.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::intake {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

// Names and numbers come from a list that anybody may have written, and become names of reports.
TEST_F(Intake, names_of_a_list_are_names_of_files) {
  const std::string group(300, 'a');
  add("submission_1/hit_box.cpp", "a");
  add("submission_2/hit_box.cpp", "b");
  add("submission_3/hit_box.cpp", "c");
  add("submission_4/hit_box.cpp", "d");
  add(kGradescopeList,
      "submission_1:\n  :submitters:\n  - :name: \"x\\e[31m\\n\\0y\"\n    :sid: \"../../up\"\n"
      "submission_2:\n  :submitters:\n  - :name: \"x\\e[31m\\n\\0y\"\n    :sid: \"../../UP\"\n"
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

TEST_F(Intake, long_names_are_cut_before_their_ending) {
  const std::string name(300, 'a');
  pt::write_file(in("class.zip"),
                 archive_of({{"bob/hit_box.cpp", "b"},
                             {"cy_1_2_" + name + ".zip", archive_of({{"hit_box.cpp", "c"}})}}));
  auto all = seen(in("class.zip"));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all["cy"].files, (Files{{"hit_box.cpp", "c"}})) << all["cy"].problem;
}

TEST_F(Intake, names_are_those_of_reports) {
  for (const char* name : {"class", "Plan", "likeness", "Zo\xc3\xab", "zo\xc3\x8b",
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
  EXPECT_EQ(all.size(), 10U);
  for (const char* name : {"class (2)", "Plan (2)", "likeness (2)", "a_b", "c_d", "e_f"}) {
    EXPECT_TRUE(all.contains(name)) << name;
  }
  EXPECT_TRUE(all.contains("Zo\xc3\xab (2)") || all.contains("zo\xc3\x8b (2)"));
  EXPECT_EQ(all["a_b"].feedback, "a_b.html");
  for (const char* name : {"gus.zip", "gus.tar.gz"}) {
    EXPECT_THAT(all[name].problem, HasSubstr("there is another 'gus'")) << name;
  }
}

// A learner may have the name that a number would make of the name of another learner.
TEST_F(Intake, a_number_behind_a_name_is_nobodys_name) {
  for (const char* name : {"Ada", "ada", "ada (2)", "class", "class (2)"}) {
    add(std::string(name) + "/hit_box.cpp", name);
  }
  auto all = seen();
  for (const auto& [report, owner] : {std::pair("Ada", "Ada"),
                                      {"ada (3)", "ada"},
                                      {"ada (2)", "ada (2)"},
                                      {"class (3)", "class"},
                                      {"class (2)", "class (2)"}}) {
    EXPECT_EQ(all[report].files, (Files{{"hit_box.cpp", owner}})) << report;
  }
}

// The number of random classes; FIRSTLIGHT_CLASSES=2000 in the long test.
int random_classes() {
  const char* asked = std::getenv("FIRSTLIGHT_CLASSES");
  return asked == nullptr ? 25 : std::stoi(asked);
}

// Classes of folders and archives whose names differ in little. The text of each file names its owner.
TEST_F(Intake, of_random_classes_every_row_is_its_owners_or_has_a_problem) {
  std::mt19937 random(70);
  const auto one_of = [&](const std::vector<std::string>& all) {
    return all[random() % all.size()];
  };
  for (int number = 0; number < random_classes(); ++number) {
    std::map<std::string, std::string> claims;  // the owner by the name without an ending
    std::map<std::string, int> claimed;
    fs::remove_all(in());
    for (int i = 0; i < 6; ++i) {
      const std::string name =
          one_of({"Ada", "ada", "ad\xc3\xa1", "ada_1", "ada 1"}) + one_of({"", "", " (2)", " (1)"});
      const std::string ending = one_of({"", "", ".zip", ".tar.gz"});
      const std::string owner = name + ending;
      if (fs::exists(in(owner))) continue;
      ++claimed[name];
      claims[name] = owner;
      const std::string task =
          one_of({"hit_box.cpp", "hit_box (1).cpp", "student/1_rays/hit_box.cpp"});
      if (ending.empty()) {
        add(owner + "/" + task, owner);
      } else {
        add(owner, archive_of({{task, owner}}, ending == ".zip" ? Format::zip : Format::tar_gz));
      }
    }
    const auto all = seen();
    for (const auto& [row, found] : all) {
      if (!found.problem.empty()) continue;
      ASSERT_EQ(found.judged.size(), 1U) << row;
      const std::string owner = found.judged.begin()->second;
      const auto mine = claims.find(row);
      EXPECT_TRUE(mine == claims.end() || mine->second == owner) << row << " has work of " << owner;
    }
    int rows = 0;
    for (const auto& [name, count] : claimed) rows += count;
    EXPECT_EQ(static_cast<int>(all.size()), rows);
  }
}

struct Learner {
  std::string name, id;
};

// The text before a learner's own name of a file, in the export of a platform.
using Before = std::function<std::string(const Learner& learner, int file)>;

std::string without_underscores(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

// Canvas writes - for the `_` around a number in the middle of a name.
std::string as_canvas_writes(const std::string& name) {
  return std::regex_replace(name, std::regex("_(\\d+)_"), "-$1-");
}

const std::vector<Before> kBefore{
    [](const Learner& by, int file) {
      return fmt::format("{}_{}_{}_", as_canvas_writes(by.name), by.id, 9000 + file);
    },
    [](const Learner& by, int) {
      return fmt::format("{}_{}_assignsubmission_file_", without_underscores(by.name), by.id);
    },
    [](const Learner& by, int) {
      return fmt::format("{}_{}_assignsubmission_file_/", without_underscores(by.name), by.id);
    },
    [](const Learner& by, int) {
      return fmt::format("{}-9 - {} - Jan 15, 2027 1005 PM - ", by.id, by.name);
    },
    [](const Learner& by, int) {
      return fmt::format("HW_1_{}{}_attempt_2027-01-15-22-05-33_", by.name, by.id);
    },
    [](const Learner& by, int file) { return fmt::format("u{}@x.org_{}_", by.id, 1 + file); },
    [](const Learner& by, int file) {
      return fmt::format("u{}@x.org_1_box_1_{}_{}_", by.id, 1 + file, 900 + file);
    },
    [](const Learner& by, int) { return fmt::format("{}, A({})/", by.name, by.id); }};

// Names of which one is the key of another, as its platform writes it, and files that are called like them.
TEST_F(Intake, of_random_exports_every_row_is_its_owners_or_has_a_problem) {
  std::mt19937 random(71);
  const auto one_of = [&](const std::vector<std::string>& all) {
    return all[random() % all.size()];
  };
  for (int number = 0; number < random_classes(); ++number) {
    fs::remove_all(in());
    const Before& before = kBefore[random() % kBefore.size()];
    std::map<std::string, std::string> ids;  // by the text of the owner's files
    std::vector<Learner> learners;
    for (int id = 1; id < 6; ++id) {
      learners.push_back({one_of({"Ada", "ada", "ad\xc3\xa1", "Ada_2", "Ada 2", "3", "Ada_3_9001",
                                  "Ada - x", "Ada (2)", "Ada_2_assignsubmission_file"}),
                          std::to_string(id)});
    }
    int file = 0;
    for (const Learner& by : learners) {
      const std::string owner = by.name + " with the ID " + by.id;
      ids[owner] = by.id;
      const std::string called = one_of({"", "", before(learners[random() % learners.size()], 8)});
      add(before(by, ++file) + "hit_box.cpp", owner);
      if (!called.empty() && called.back() != '/')
        add(before(by, ++file) + called + "hit_box.cpp", owner);
    }
    std::set<std::string> owners;
    bool has_problem = false;
    for (const auto& [row, found] : seen()) {
      has_problem = has_problem || !found.problem.empty();
      if (!found.problem.empty()) continue;
      ASSERT_EQ(found.judged.size(), 1U) << row;
      const std::string owner = found.judged.begin()->second;
      EXPECT_TRUE(owners.insert(owner).second) << owner << " has two rows";
      EXPECT_TRUE(found.id.empty() || found.id.find(ids[owner]) != found.id.npos)
          << row << " with the ID " << found.id << " has work of " << owner;
    }
    std::string files;
    for (const auto& entry : fs::recursive_directory_iterator(in()))
      files += fs::relative(entry.path(), in()).string() + '\n';
    EXPECT_TRUE(has_problem || owners.size() == learners.size()) << files;
  }
}

// Forty learners, in exports of twelve platforms: every row has the name, the ID and the work that it should have.
TEST_F(Intake, a_class_out_of_exports_of_twelve_platforms_is_right_in_every_row) {
  const std::vector<Learner> learners{{"Ada", "11"}, {"ada", "12"}, {"Zo\xc3\xab", "13"}};
  const std::vector<Learner> four{
      {"Ada L", "11"}, {"Bob", "12"}, {"Zo\xc3\xab M", "13"}, {"Ad L", "1"}};
  const std::vector<Before> others{
      [](const Learner& by, int) {
        return "course-hw1-" + by.name + "/student/1_rays/";
      },                                                                    // GitHub
      [](const Learner& by, int) { return by.name + "/Version 1/"; },       // Teams
      [](const Learner& by, int) { return by.name + "_" + by.id + "/"; }};  // ILIAS
  int rows = 0;
  const auto judge = [&](const Before& before, const std::vector<Learner>& all, bool has_name,
                         bool has_id) {
    fs::remove_all(in());
    int file = 0;
    for (const Learner& by : all) add(before(by, ++file) + "hit_box.cpp", by.name + "/" + by.id);
    const auto seen_rows = seen();
    EXPECT_EQ(seen_rows.size(), all.size()) << before(all[0], 0);
    for (const Learner& by : all) {
      const auto is_row = [&](const auto& row) {
        const Files judged{{"hit_box", by.name + "/" + by.id}};
        const std::string& id = row.second.id;
        return row.second.judged == judged && row.second.problem.empty() &&
               (!has_name || row.first.starts_with(without_underscores(by.name))) &&
               (!has_id || id == by.id || id == by.id + "-9" || id == "u" + by.id + "@x.org");
      };
      EXPECT_EQ(std::ranges::count_if(seen_rows, is_row), 1) << before(by, 0);
      ++rows;
    }
  };
  constexpr std::size_t kBlackboard = 4, kAutolab = 5, kPrairieLearn = 6;
  for (std::size_t i = 0; i < kBefore.size(); ++i) {
    const bool has_name = i != kBlackboard && i != kAutolab && i != kPrairieLearn;
    judge(kBefore[i], i % 2 == 0 ? four : learners, has_name, i != kBlackboard);
  }
  for (const Before& before : others) judge(before, learners, false, false);
  // Gradescope's list has the names.
  std::string list;
  fs::remove_all(in());
  for (const Learner& by : learners) {
    add("submission_" + by.id + "/hit_box.cpp", by.id);
    list += fmt::format("submission_{0}:\n  :submitters:\n  - :name: {1}\n    :sid: {0}\n", by.id,
                        by.name);
  }
  add(kGradescopeList, list);
  for (const auto& [name, row] : seen()) {
    EXPECT_EQ(row.judged, (Files{{"hit_box", row.id}})) << name << row.problem;
    ++rows;
  }
  EXPECT_EQ(rows, 40);
}

// A name as a learner's computer writes it and as a platform does.
const char* const kComposed = "Zo\xc3\xab";
const char* const kWithMarks = "Zoe\xcc\x88";

TEST_F(Intake, names_that_differ_in_accents_as_bytes_only_are_two) {
  for (const std::string& name : {std::string(kComposed), std::string(kWithMarks)}) {
    add(name + "/hit_box.cpp", name);
    add(fmt::format("{} K_{}_assignsubmission_file_/hit_box.cpp", name, name.size()), name + " K");
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

// The same holds if their folders have no file in common, or if their archives are equal.
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
  // A platform's number identifies one learner, and a name does not collide with itself.
  pt::write_file(in("class.zip"),
                 archive_of({{one + "_7_assignsubmission_file_/hit_box.cpp", "1"},
                             {"ada/hit_box.cpp", "a"},
                             {"bob/hit_box.cpp", "b"},
                             {"ada/hit_sphere.cpp", "a"},
                             {one + "_7_assignsubmission_file_/hit_sphere.cpp", "1"}}));
  for (const auto& [name, found] : seen(in("class.zip"))) EXPECT_EQ(found.problem, "") << name;
}

}  // namespace
}  // namespace grader::intake
