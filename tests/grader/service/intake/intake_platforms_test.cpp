// Exports of Canvas, Moodle, Gradescope and others become one folder per learner.
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

}  // namespace
}  // namespace grader::intake
