// The forms of names: those of the platforms, and those of a table that an instructor writes.
#include "grader/service/intake/form_table.h"

#include "grader/service/intake/owner.h"
#include "grader/service/intake/written_date.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/grader/service/intake/intake.h"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace grader::intake {
namespace {

using testing::HasSubstr;

// A platform's name for a file, and what it says.
struct Form {
  const char* file;
  const char* name;
  const char* id;
  const char* called;  // by the learner
  bool late = false;
};

TEST(labels, are_read_in_every_form_of_every_platform) {
  const Form forms[] = {
      {"lovelaceada_123_456_hit_box-1.cpp", "lovelaceada", "123", "hit_box-1.cpp"},
      {"lovelaceada_LATE_123_456_work.zip", "lovelaceada", "123", "work.zip", true},
      {"o_neil_123_456_work.zip", "o_neil", "123", "work.zip"},
      {"team_7_123_900_work.zip", "team_7", "123", "work.zip"},
      {"team_7_LATE_123_900_hit_box.cpp", "team_7", "123", "hit_box.cpp", true},
      {"7_8_123_900_work.zip", "7_8", "123", "work.zip"},
      // A user of another school has an ID of more digits than a file's number.
      {"ada_10000000000123_900_work.zip", "ada", "10000000000123", "work.zip"},
      {"team_7_10000000000123_900_work.zip", "team_7", "10000000000123", "work.zip"},
      {"team_7_10000000000123_text.html", "team_7", "10000000000123", "text.html"},
      {"bob__123_900_work.zip", "bob_", "123", "work.zip"},
      {"ada_123_900_1_rays.zip", "ada", "123", "1_rays.zip"},
      {"ada_123_900_2_3_rays.zip", "ada", "123", "2_3_rays.zip"},
      {"ada_123_text.html", "ada", "123", "text.html"},
      {"team_7_123_text.html", "team_7", "123", "text.html"},
      {"team_7_123_link.html", "team_7", "123", "link.html"},
      {"anon_aB3xz_901_hit_box.cpp", "anon_aB3xz", "anon_aB3xz", "hit_box.cpp"},
      {"anon_12345_901_1_rays.zip", "anon_12345", "anon_12345", "1_rays.zip"},
      {"LATE_anon_aB3xz_901_hit_box.cpp", "anon_aB3xz", "anon_aB3xz", "hit_box.cpp", true},
      {"anon_aB3xz_LATE_901_hit_box.cpp", "anon_aB3xz", "anon_aB3xz", "hit_box.cpp", true},
      {"anon_aB3xz_text.html", "anon_aB3xz", "anon_aB3xz", "text.html"},
      {"Ada Lovelace_55_assignsubmission_file_hit_box.cpp", "Ada Lovelace", "55", "hit_box.cpp"},
      {"Ada Lovelace_55_assignsubmission_file", "Ada Lovelace", "55", ""},
      {"Ada Lovelace_55_assignsubmission_file_", "Ada Lovelace", "55", ""},
      {"Participant_55_assignsubmission_onlinetext_", "Participant", "55", ""},
      {"Default group_assignsubmission_file_hit_box.cpp", "Default group", "", "hit_box.cpp"},
      {"Ada_5_assignsubmission_file_Bob_55_assignsubmission_file_x.cpp", "Ada", "5",
       "Bob_55_assignsubmission_file_x.cpp"},
      {"Ada_5_assignsubmission_file_a\nb.cpp", "Ada", "5", "a\nb.cpp"},
      {"12-34 - Ada Ace - Jan 15, 2027 1005 PM - hit_box.cpp", "Ada Ace", "12-34", "hit_box.cpp"},
      {"12-34 - Ada - Ace - 15 January, 2027 1005 PM - a - b.cpp", "Ada - Ace", "12-34",
       "a - b.cpp"},
      {"12-34 - Ada Ace - Jan 15, 2027 2205 - hit_box.cpp", "Ada Ace", "12-34", "hit_box.cpp"},
      {"12-34 - Ada Ace - 2027-01-15 22 05 - hit_box.cpp", "Ada Ace", "12-34", "hit_box.cpp"},
      {"12-34 - Ada Ace - 15 mai 2027 2205 - hit_box.cpp", "Ada Ace", "12-34", "hit_box.cpp"},
      {"12-34 - Ada Ace - 15. Jänner 2027 22 05 - hit_box.cpp", "Ada Ace", "12-34", "hit_box.cpp"},
      {"12-34 - Ada Ace - 2027年1月15日 2205 - hit_box.cpp", "Ada Ace", "12-34", "hit_box.cpp"},
      {"12-34 - Ada Ace - 1 May 2027 905 p.m.", "Ada Ace", "12-34", ""},
      {"12-34 - Ada Ace - 01-15-2027 1005 PM - hit_box.cpp", "Ada Ace", "12-34", "hit_box.cpp"},
      {"HW 1_gus_attempt_2027-01-15-22-05-33_hit_box.cpp", "gus", "", "hit_box.cpp"},
      {"HW_1_gus_attempt_2027-01-15-22-05-33.txt", "gus", "", "txt"},
      {"HW1_gus_attempt_2027-01-15-22-05-33_HW1_eve_attempt_2027-01-16-22-05-33_hit_box.cpp", "gus",
       "", "HW1_eve_attempt_2027-01-16-22-05-33_hit_box.cpp"},
      {"s_smith@school.edu_3_hit_box.cpp", "s_smith@school.edu", "s_smith@school.edu",
       "hit_box.cpp"},
  };
  for (const Form& form : forms) {
    const std::vector<std::string> names{form.file};
    const bool is_folder = form.called == std::string();
    const Labels labels(is_folder ? std::vector<std::string>() : names,
                        is_folder ? names : std::vector<std::string>(), known_forms());
    const auto label = labels.of(form.file);
    ASSERT_TRUE(label) << form.file;
    EXPECT_EQ(label->name, form.name) << form.file;
    EXPECT_EQ(label->id, form.id) << form.file;
    EXPECT_EQ(label->file, form.called) << form.file;
    EXPECT_EQ(label->late, form.late) << form.file;
    EXPECT_EQ(label->before + label->file, form.file);
  }
  for (const char* name :
       {"notes.txt", "hit_box.cpp", "ada.zip", "ada_1.zip", "_1_2_x", "1_2_x", "ada_1_2_",
        "ada_1_2", "ada - bob - x.cpp", "12-34 - Ada - soon - x.cpp", "12-34 - Ada", "x_attempt_y",
        "hw_attempt_2027-01-15-22-05-33_x.cpp", "a@b_3_x", "@b.c_3_x", "a@b.c_x",
        "_assignsubmission_file_x", "Ada_5_assignsubmission_files"}) {
    EXPECT_FALSE(Labels({name}, {}, known_forms()).of(name)) << name;
  }
}

// The forms of a table in a file of its own.
std::vector<NameForm> forms_of(const std::string& table) {
  const std::string path = testing::TempDir() + "/forms_" + std::to_string(getpid()) + ".csv";
  pt::write_file(path, table);
  return read_name_forms(path);
}

TEST(labels, of_a_table_have_the_fields_of_the_form) {
  const auto forms = forms_of(
      "platform,pattern\nSakai,\"{name}, {any}({id})\"\nours,{id}.{attempt}.{name}-{file}\n");
  const std::vector<std::string> files{"7.9.Ada-hit_box.cpp", "7.10.Ada-a-b.cpp",
                                       "8.1.Bob-hit_box.cpp"};
  const Labels labels(files, {"Lovelace, Ada(alov)", "of nobody"}, forms);
  const auto first = labels.of(files[0]), second = labels.of(files[1]), third = labels.of(files[2]);
  ASSERT_TRUE(first && second && third);
  EXPECT_EQ(first->name + "/" + first->id + "/" + first->file, "Ada/7/hit_box.cpp");
  EXPECT_EQ(first->key, second->key);
  EXPECT_NE(first->key, third->key);
  EXPECT_LT(first->attempt, second->attempt);  // 9 before 10
  EXPECT_EQ(first->rival_key, "");
  EXPECT_EQ(second->rival_name, "Ada-a");  // a learner may have written either
  const auto folder = labels.of("Lovelace, Ada(alov)");
  ASSERT_TRUE(folder);
  EXPECT_EQ(folder->name + "/" + folder->id + "/" + folder->file, "Lovelace/alov/");
  EXPECT_FALSE(labels.of("of nobody"));
  EXPECT_FALSE(Labels(files, {}, known_forms()).of(files[0]));
  // A part that failed once is not tried again: else this takes years.
  const NameForm long_form = name_form("x", "{any}-{any}-{any}-{any}-{any}-{any}-{any}-{name}x");
  EXPECT_FALSE(read_by(long_form, std::string(250, '-'), true));
  EXPECT_FALSE(read_by(name_form("x", "{name}a{file}a{ending}b"), std::string(250, 'a'), false));
}

TEST(labels, of_a_bad_table_are_refused_with_the_line) {
  for (const auto& [table, words] : std::vector<std::pair<std::string, std::string>>{
           {"form\nx\n", ":1: it has no column 'platform'"},
           {"platform,pattern\na\n", ":2: it needs a platform and a pattern"},
           {"platform,pattern\na,{name}\nb,{nom}_{file}\n",
            ":3: '{nom}_{file}': there is no field {nom}"},
           {"platform,pattern\na,{file}\n", "it has no {name} and no {id}"},
           {"platform,pattern\na,{name}{file}\n", "two fields need some text between them"},
           {"platform,pattern\na,{name}_{name}\n", "it has a field twice"},
           {"platform,pattern\na,{name}[_{file}\n", "a [ needs a ] behind it"},
           {"platform,pattern\na,{name}_{same}_{file}\n", "{same} has to be the first field"},
           {"platform,pattern\na,{name}.{ending}\n", "{ending} is that of a {file}"}}) {
    EXPECT_THAT([&table = table] { forms_of(table); },
                testing::ThrowsMessage<pt::Error>(HasSubstr(words)));
  }
}

TEST(written_date, is_a_time_of_moodle_too) {
  EXPECT_EQ(written_date("Friday, 15 January 2027, 10:05 PM").time, "2027-01-15 22:05");
  EXPECT_EQ(written_date("Tuesday, 2 March 2027, 12:05 AM").time, "2027-03-02 00:05");
  EXPECT_EQ(written_date("2027-01-15-22-05-33").time, "2027-01-15 22:05");
  EXPECT_EQ(written_date("-").time, "");
}

TEST(labels, of_several_attempts_are_in_the_order_of_their_dates) {
  for (const auto& dates : std::vector<std::vector<std::string>>{
           {"Jan 9, 2027 905 AM", "Jan 15, 2027 1205 AM", "Jan 15, 2027 905 AM",
            "Jan 15, 2027 1205 PM", "Jan 15, 2027 905 PM", "Feb 1, 2027 905 AM"},
           {"9 January, 2027 905 a.m.", "15 January, 2027 1205 AM", "15 January, 2027 905 p.m."},
           {"Dec 31, 2026 2359", "Jan 1, 2027 0005", "Jan 1, 2027 2005"},
           {"2027-01-09 22 05", "2027-01-15 09 05", "2027-02-01 00 05"},
           {"9 janv. 2027 22 05", "1 févr. 2027 09 05", "1 avr. 2027 09 05", "3 juin 2027 09 05",
            "2 juil. 2027 09 05", "1 août 2027 09 05", "1 déc. 2027 09 05"},
           {"9 Januar 2027 2205", "1 März 2027 0905", "1 Mai 2027 0905", "1 Okt 2027 0905",
            "1 Dez 2027 0905"}}) {
    std::string before;
    for (const std::string& date : dates) {
      const std::string name = "1-2 - Ada - " + date + " - x.cpp";
      const auto label = Labels({name}, {}, known_forms()).of(name);
      ASSERT_TRUE(label) << date;
      EXPECT_LT(before, label->attempt) << date;
      before = label->attempt;
    }
  }
}

}  // namespace
}  // namespace grader::intake
