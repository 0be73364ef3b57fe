// Exports of Canvas, Moodle, Gradescope and others become one folder per learner.
#include "grader/service/intake/owner.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/grader/service/intake/intake.h"

#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::intake {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

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

// A learner of a young school may be called like another one with an ID: lovelaceada_123 has the ID 456.
TEST_F(Intake, a_file_of_canvas_that_may_be_two_learners_is_nobodys) {
  add("lovelaceada_123_470_hit_box.cpp", "Ada's");
  add("hopper_7_480_hit_box.cpp", "Grace's");
  add("lovelaceada_123_456_490_hit_box.cpp", "whose?");
  add("hopper_7_481_1_hit_sphere.cpp", "1 is no file's number");
  auto all = seen();
  EXPECT_THAT(all["lovelaceada"].problem, HasSubstr("or of 'lovelaceada_123' with the ID 456"));
  EXPECT_EQ(all["hopper"].problem, "");
  EXPECT_EQ(all["hopper"].files.at("hit_box.cpp"), "Grace's");
}

// A learner's name for a file may begin with a date.
TEST_F(Intake, a_date_is_no_number_of_canvas) {
  add("lovelaceada_1234_10000470_hit_box.cpp", "Ada's");
  add("hopper_1235_10000480_20270115_work.zip", archive_of({{"hit_box.cpp", "Grace's"}}));
  for (const auto& [name, found] : seen()) EXPECT_EQ(found.problem, "") << name;
}

// An ID of Gradescope may be any text.
TEST_F(Intake, an_id_with_commas_is_one_id) {
  for (int i = 1; i <= 3; ++i) add(fmt::format("submission_{}/hit_box.cpp", i), std::to_string(i));
  add(kGradescopeList,
      "submission_1:\n  :submitters:\n  - :name: Ada\n    :sid: \"1001\"\n"
      "submission_2:\n  :submitters:\n  - :name: Grace\n    :sid: \"1002\"\n"
      "submission_3:\n  :submitters:\n  - :name: Mal\n    :sid: \"1001, 1002, 1003\"\n");
  for (const auto& [name, found] : seen()) EXPECT_EQ(found.problem, "") << name;
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

// The form of a name is that of the platform, not that which a learner has written into it.
TEST_F(Intake, a_name_that_a_learner_chose_is_nobody_elses) {
  const std::string stub = "stub", date = "2027-01-15-22-05-00";
  const std::vector<std::pair<std::string, std::string>> classes{
      {"Eve_5_assignsubmission_file_", "Bob_55_assignsubmission_file_"},
      {"HW1_eve_attempt_" + date + "_", "HW1_bob_attempt_" + date + "_"},
      {"eve_5_800_", "bob_55_901_"},
      {"1-2 - Eve - Jan 15, 2027 1005 PM - ", "55-2 - Bob - Jan 15, 2027 1005 PM - "},
      {"eve@x.org_1_", "bob@x.org_1_"}};
  for (const auto& [eves, bobs] : classes) {
    fs::remove_all(in());
    add(bobs + "hit_box.cpp", "right");
    const auto before = seen();
    ASSERT_EQ(before.size(), 1U) << bobs;
    for (const auto& [other, forged] : classes) {
      fs::remove_all(in());
      add(bobs + "hit_box.cpp", "right");
      std::string prefix = eves;
      for (const std::string& upload : {forged, other, std::string(), bobs}) {
        add(prefix + upload + "hit_box.cpp", stub);
        // Canvas numbers every file.
        if (eves == "eve_5_800_") ++prefix[eves.size() - 2];
      }
      auto all = seen();
      EXPECT_EQ(all.size(), 2U) << eves << forged;
      int same = 0;
      for (const auto& [name, row] : all) {
        same += row.judged == Files{{"hit_box", "right"}} && row.problem.empty() &&
                        row.id == before.begin()->second.id
                    ? 1
                    : 0;
      }
      EXPECT_EQ(same, 1) << eves << forged;
    }
  }
}

TEST_F(Intake, names_that_end_in_a_number_are_whole) {
  add("jdoe_3_44_903_hit_box.cpp", "b");
  add("jdoe_3_44_904_hit_sphere.cpp", "s");
  add("team_7_123_905_work.zip", archive_of({{"hit_box.cpp", "t"}}));
  add("carl_7_906_hit_box.cpp", "c");
  auto all = seen();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all["jdoe_3"].files, (Files{{"hit_box.cpp", "b"}, {"hit_sphere.cpp", "s"}}));
  EXPECT_EQ(all["jdoe_3"].id, "44");
  EXPECT_EQ(all["team_7"].id, "123");
  EXPECT_EQ(all["team_7"].judged, (Files{{"hit_box", "t"}}));
  EXPECT_EQ(all["carl"].id, "7");
  EXPECT_EQ(all["carl"].problem, "");
}

TEST_F(Intake, two_rows_with_one_id_are_named_and_have_none) {
  add("Ada_55_assignsubmission_file_/hit_box.cpp", "a");
  add("Bob_55_assignsubmission_file_/hit_box.cpp", "b");
  add("Cy_56_assignsubmission_file_/hit_box.cpp", "c");
  add("1-2 - Di - Jan 15, 2027 1005 PM/hit_box.cpp", "d");
  add("1-2 - Eve - Jan 15, 2027 1005 PM/hit_box.cpp", "e");
  auto all = seen();
  ASSERT_EQ(all.size(), 5U);
  EXPECT_THAT(all["Ada"].problem, HasSubstr("its ID '55' is also that of 'Bob'"));
  EXPECT_THAT(all["Bob"].problem, HasSubstr("its ID '55' is also that of 'Ada'"));
  for (const char* name : {"Ada", "Bob", "Di", "Eve"}) {
    EXPECT_EQ(all[name].id, "") << name;
    EXPECT_NE(all[name].problem, "") << name;
  }
  EXPECT_EQ(all["Cy"].problem, "");
  fs::remove_all(in());
  add("submission_1/hit_box.cpp", "a");
  add("submission_2/hit_box.cpp", "b");
  add(kGradescopeList,
      "submission_1:\n  :submitters:\n  - :name: Ada\n    :sid: 7\n  - :name: Bob\n    :sid: 8\n"
      "submission_2:\n  :submitters:\n  - :name: Bob\n    :sid: 8\n");
  for (const auto& [name, one] : seen()) EXPECT_THAT(one.problem, HasSubstr("'8'")) << name;
}

TEST_F(Intake, user_names_of_blackboard_are_whole) {
  add("HW1_s_smith_attempt_2027-01-15-22-05-33_hit_box.cpp", "s");
  add("HW1_j_smith_attempt_2027-01-15-22-05-33_hit_box.cpp", "j");
  auto all = seen();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all["s_smith"].judged, (Files{{"hit_box", "s"}}));
  EXPECT_EQ(all["j_smith"].judged, (Files{{"hit_box", "j"}}));
}

// The name of each attempt begins with `before`, and %s is its date or number.
TEST_F(Intake, of_several_attempts_the_last_counts) {
  const auto zip = [](const Files& files) {
    std::vector<Entry> entries;
    for (const auto& [name, text] : files) entries.push_back({name, text});
    return archive_of(entries);
  };
  const auto three = [](const std::string& before, const std::vector<std::string>& dates,
                        const std::string& after) {
    std::vector<std::string> all;
    for (const std::string& date : dates) all.push_back(before + date + after);
    return all;
  };
  const std::vector<std::vector<std::string>> platforms{
      three("HW_ada_attempt_",
            {"2027-01-01-00-00-00", "2027-01-02-00-00-00", "2027-01-03-00-00-00"}, "_"),
      three("1-2 - Ada - ", {"Dec 1, 2026 905 PM", "Jan 2, 2027 905 AM", "Jan 2, 2027 905 PM"},
            " - "),
      three("ada@x.org_", {"2", "9", "10"}, "_")};
  for (const std::vector<std::string>& at : platforms) {
    SCOPED_TRACE(at[0]);
    const auto judged = [&](const std::vector<std::pair<std::string, std::string>>& files) {
      fs::remove_all(in());
      add("bob/hit_box.cpp", "b");
      for (std::size_t i = 0; i < files.size(); ++i) add(at[i] + files[i].first, files[i].second);
      auto all = seen();
      EXPECT_EQ(all.size(), 2U);
      all.erase("bob");
      return all.begin()->second;
    };
    const Files box{{"hit_box", "new"}}, both{{"hit_box", "new"}, {"hit_sphere", "old"}};
    EXPECT_EQ(judged({{"hit_box.cpp", "old"}, {"work.zip", zip({{"hit_box.cpp", "new"}})}}).judged,
              box);
    EXPECT_EQ(judged({{"work.zip", zip({{"hit_box.cpp", "old"}})},
                      {"work_v2.zip", zip({{"hit_box.cpp", "new"}})}})
                  .judged,
              box);
    EXPECT_EQ(judged({{"work.zip", zip({{"hit_box.cpp", "old"}, {"a/hit_sphere.cpp", "old"}})},
                      {"hit_box.cpp", "new"}})
                  .judged,
              both);
    EXPECT_EQ(judged({{"hit_box.cpp", "old"}, {"hit_box (1).cpp", "new"}}).judged, box);
    EXPECT_EQ(judged({{"hit_box.cpp", "old"}, {"hit_box.cpp", "new"}, {"report.pdf", "?"}}).judged,
              box);
    EXPECT_THAT(judged({{"hit_box.cpp", "old"}, {"hit_box.cpp", "new"}}).note,
                HasSubstr("of several attempts the last counts"));
    EXPECT_THAT(judged({{"hit_box.cpp", "old"}, {"work.zip", "broken"}}).problem,
                HasSubstr("cannot be unpacked"));
  }
  fs::remove_all(in());
  add("1-2 - Ada - 9 toukokuuta 2027 905 - hit_box.cpp", "?");
  add("1-2 - Ada - 1 kesäkuuta 2027 905 - hit_box.cpp", "?");
  EXPECT_THAT(seen()["Ada"].problem, HasSubstr("their dates cannot be read"));
}

// Clones of GitHub with its list, and repositories as Artemis packs them.
TEST_F(Intake, repositories_are_one_row_each) {
  add("clones/hw-ada/.git/HEAD", "ref");
  add("clones/hw-ada/pt/a.h", "");
  add("clones/hw-ada/student/1_rays/hit_box.cpp", "a");
  add("clones/hw-bob/.git/HEAD", "ref");
  add("clones/hw-bob/student/1_rays/hit_box.cpp", "b");
  add("clones/grades.csv", "?");
  auto all = seen();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all["hw-ada"].judged, (Files{{"hit_box", "a"}}));
  EXPECT_EQ(all["hw-bob"].judged, (Files{{"hit_box", "b"}}));
  EXPECT_FALSE(work_is_unclaimed_);
  fs::remove_all(in());
  for (const char* name : {"ada", "bob"}) {
    const std::string folder = std::string("hw1-") + name;
    add("course-hw1-" + std::string(name) + "-student-submission.git.zip",
        archive_of({{folder + "/student/1_rays/hit_box.cpp", name}, {folder + "/.git/HEAD", "r"}}));
  }
  all = seen();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all["course-hw1-ada-student-submission.git"].judged, (Files{{"hit_box", "ada"}}));
}

// Submitty has a folder for each attempt. It grades by itself, so that nobody needs these files.
TEST_F(Intake, files_that_are_not_read_have_a_reason) {
  for (const char* path : {"ada/1/hit_box.cpp", "ada/2/hit_box.cpp", "bob/1/hit_box.cpp"})
    add(path, path);
  auto all = seen();
  EXPECT_EQ(all["ada"].problem,
            "it has hit_box.cpp in 2 places, '1/hit_box.cpp' and '2/hit_box.cpp'; keep one");
  EXPECT_EQ(all["bob"].judged, (Files{{"hit_box", "bob/1/hit_box.cpp"}}));
}

// A form without {file} is that of folders and of archives, in an archive of the whole class too.
TEST_F(Intake, an_instructor_adds_a_form_of_names) {
  forms_ = {name_form("ours", "{any}_{name}_{number}"),
            name_form("Google Forms", "{file} - {name}.{ending}")};
  const std::vector<Entry> entries{
      {"hw/x_Ada_7/hit_box.cpp", "a"},
      {"hw/x_Ada_7.zip", archive_of({{"hit_sphere.cpp", "a"}})},
      {"hw/x_Bob_8.tar.gz", archive_of({{"hit_box.cpp", "b"}}, Format::tar_gz)},
      {"hw/hit_box - Cy.cpp", "c"},
      {"hw/hit_sphere - Cy.cpp", "c"},
      {"hw/work - Di D.zip", archive_of({{"hit_box.cpp", "d"}})},
      {"hw/hit_box - Cy - Eve.cpp", "e"}};
  for (const Entry& entry : entries) add(entry.path, entry.text);
  pt::write_file(folder_.path() + "/class.zip", archive_of(entries));
  for (const fs::path& input : {in(), fs::path(folder_.path()) / "class.zip"}) {
    auto all = seen(input);
    EXPECT_EQ(all.size(), 5U);
    EXPECT_EQ(all["Ada"].id, "7");
    EXPECT_EQ(all["Ada"].judged, (Files{{"hit_box", "a"}, {"hit_sphere", "a"}}));
    EXPECT_THAT(all["Ada"].note, HasSubstr("beside the other files counts"));
    EXPECT_EQ(all["Bob"].judged, (Files{{"hit_box", "b"}})) << all["Bob"].problem;
    EXPECT_EQ(all["Cy"].judged, (Files{{"hit_box", "c"}, {"hit_sphere", "c"}}));
    EXPECT_EQ(all["Di D"].judged, (Files{{"hit_box", "d"}})) << all["Di D"].problem;
    EXPECT_THAT(all["Cy - Eve"].problem, HasSubstr("or of 'Eve'"));
  }
}

TEST_F(Intake, files_of_learners_without_names_are_refused) {
  for (const char* second : {"hit_box(1).cpp", "hit_box (2).cpp", "Hit_Box(1).cpp",
                             "Copy of hit_box.cpp", "Copy of Copy of hit_box.cpp"}) {
    fs::remove_all(in());
    add("HW1/hit_box.cpp", "a");
    add(std::string("HW1/") + second, "b");
    EXPECT_THAT([&] { seen(); },
                testing::ThrowsMessage<pt::Error>(HasSubstr("does not say whose they are")))
        << second;
  }
}

}  // namespace
}  // namespace grader::intake
