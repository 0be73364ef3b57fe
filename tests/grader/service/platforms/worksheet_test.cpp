// Moodle's grading worksheet, filled in.
#include "grader/service/platforms/worksheet.h"

#include "pt/error.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::platforms {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kColumns =
    "Identifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum Grade\",\"Grade can be "
    "changed\",\"Last modified (submission)\",\"Last modified (grade)\",\"Feedback comments\"";

const std::vector<GradeRow> kLearners{{"Ada", "7", true, 22, "12 of 12 tasks pass."},
                                      {"Zoë", "18", false, 0, "it holds \"a\", and \"b\""}};

std::string filled(const std::string& text, const std::vector<GradeRow>& rows = kLearners) {
  return Worksheet(text, "sheet.csv").filled(rows, 20).text;
}

std::string complaint(const std::string& text) {
  try {
    filled(text);
    return "";
  } catch (const pt::Error& error) {
    return error.what();
  }
}

TEST(Worksheet, is_filled_in_and_stays_the_same_elsewhere) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    for (const char* mark : {"", "\xef\xbb\xbf"}) {
      const std::string before = fmt::format(
          "{}{}{}Participant 6,\"Bob \"\"B\"\"{}Jr\",b@x,No submission,,20.00,Yes,-,-,\"so{}so\"{}"
          "Participant 7,\"Łukasz 北\",a@x,Submitted,3.00,20.00,Yes,\"Monday, 4\",-,old{}"
          "Participant 18,زوي,z@x,Submitted,4.00,20.00,Yes,-,-,{}",
          mark, kColumns, end, end, end, end, end, end);
      std::string after = before;
      after.replace(after.find("3.00"), 4, "20");
      after.replace(after.find("old"), 3, "12 of 12 tasks pass.");
      after.insert(after.size() - std::string(end).size(), R"("it holds ""a"", and ""b""")");
      EXPECT_EQ(filled(before), after);
      EXPECT_EQ(filled(after), after) << "what was filled in is filled in again";
    }
  }
}

TEST(Worksheet, has_the_times_of_submissions) {
  const Worksheet sheet(
      "Identifier,Full name,Group,Grade,Maximum Grade,Grade can be changed,Last modified "
      "(submission)\n"
      "Participant 7,Ada,,,20,Yes,\"Friday, 15 January 2027, 10:05 PM\"\n"
      "Participant 8,Bob,Team,,20,Yes,one\nParticipant 9,Cy,Team,,20,Yes,two\n",
      "sheet.csv");
  const auto times = sheet.modified({{"Ada", "7", false, 0, ""}, {"Team", "55", false, 0, ""}});
  EXPECT_THAT(times.at("Ada"), ElementsAre("Friday, 15 January 2027, 10:05 PM"));
  EXPECT_THAT(times.at("Team"), ElementsAre("one", "two"));
  EXPECT_TRUE(
      Worksheet("Identifier,Grade,Maximum Grade,Grade can be changed\n", "s").modified({}).empty());
}

TEST(Worksheet, a_spreadsheet_may_have_saved_it) {
  EXPECT_EQ(filled("Identifier;Grade;Maximum Grade;Grade can be changed\nParticipant 7;;20,00;Yes"),
            "Identifier;Grade;Maximum Grade;Grade can be changed\nParticipant 7;20;20,00;Yes");
  EXPECT_EQ(
      filled(
          "Identifier\tGrade\tMaximum Grade\tGrade can be changed\n\nParticipant 7\t\t20\tYes\n"),
      "Identifier\tGrade\tMaximum Grade\tGrade can be changed\n\nParticipant 7\t20\t20\tYes\n");
}

// Moodle hides names in blind marking, and its columns come in any order.
TEST(Worksheet, columns_are_found_by_name) {
  EXPECT_EQ(filled("Feedback comments,Grade can be changed,Maximum Grade,Grade,Status,Identifier\n"
                   "old,Yes,20,1,s,Participant 7\n"),
            "Feedback comments,Grade can be changed,Maximum Grade,Grade,Status,Identifier\n"
            "12 of 12 tasks pass.,Yes,20,20,s,Participant 7\n");
}

TEST(Worksheet, what_is_locked_or_missing_is_counted) {
  const std::string text = std::string(kColumns) + "\nParticipant 7,A,a,s,3,20,No,-,-,old\n";
  const Worksheet::Filled filled = Worksheet(text, "sheet.csv").filled(kLearners, 20);
  EXPECT_EQ(filled.text, text);
  EXPECT_EQ(filled.locked, 1U);
  EXPECT_THAT(filled.strays, ElementsAre("Zoë"));
}

TEST(Worksheet, nobody_is_told_a_grade_out_of_another_maximum) {
  const auto with = [](const char* maximum) {
    return fmt::format("{}\n\nParticipant 7,A,a,s,3,{},Yes,-,-,\n", kColumns, maximum);
  };
  for (const char* maximum : {"100.00", "-", "20 points", ""}) {
    EXPECT_THAT(
        complaint(with(maximum)),
        HasSubstr(fmt::format("sheet.csv:3: Moodle's maximum is '{}', and there are 20 points; "
                              "make 20 the maximum grade",
                              maximum)));
  }
  EXPECT_EQ(complaint(with("20.00000")), "");
}

TEST(Worksheet, what_is_none_is_named_with_its_line) {
  const std::string columns = kColumns, row = "\nParticipant 7,A,a,s,,20,Yes,-,-,";
  for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
           {"", ":1: it is empty"},
           {"\xef\xbb\xbf", ":1: it is empty"},
           {"Kennung,Bewertung" + row,
            ":1: it has no column 'Identifier'; download the grading "
            "worksheet with Moodle in English"},
           {"Identifier,Maximum Grade\n", ":1: it has no column 'Grade'"},
           {columns + row + row, ":3: 'Participant 7' has a row already"},
           {columns + row + ",", ":2: it has 11 cells, and the first line 10"},
           {columns + "\nParticipant 7", ":2: it has 1 cells"},
           {columns + "\r\n\r\nParticipant 7", ":3: it has 1 cells"},
           {columns + "\nada@x,A,a,s,,20,Yes,-,-,", ":2: 'ada@x' is not a participant"},
           {columns + row + "\"a\nb\"\n,", ":4: it has 2 cells"},
           {columns + row + "\n\"a\n\n", ":3: a quotation that begins here does not end"},
           {columns + row + "\n\"a\n\"b,", ":4: a cell goes on behind its quotation mark"},
           {columns + row + "caf\xe9", ":2: it is not UTF-8; save it as CSV in UTF-8"}}) {
    EXPECT_THAT(complaint(text), testing::StartsWith("sheet.csv" + words)) << text;
  }
}

TEST(ReadCsv, says_where_each_cell_stands) {
  const std::string text = "\"a\"\"\r\nb\";c\n\n;\"\"";
  const report::CsvTable table = report::read_csv(text, "t.csv");
  EXPECT_EQ(table.separator, ';');
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].cells[0].value, "a\"\r\nb");
  EXPECT_EQ(text.substr(table.rows[0].cells[0].at, table.rows[0].cells[0].size), "\"a\"\"\r\nb\"");
  EXPECT_EQ(table.rows[1].line, 4);
  ASSERT_EQ(table.rows[1].cells.size(), 2U);
  EXPECT_EQ(table.rows[1].cells[0].value, "");
}

// The number in the name of a group's files is the group's, not a participant's.
TEST(Worksheet, a_groups_grade_is_for_its_members) {
  const std::string head =
      "Identifier,Full name,Group,Grade,Maximum Grade,Grade can be changed,Feedback comments\n";
  const auto row = [](const char* who, const char* group, const char* grade) {
    return fmt::format("{},{},{},20,Yes,{}\n", who, group, grade, *grade == 0 ? "" : "fine");
  };
  const std::vector<GradeRow> teams{{"Team A", "5", true, 9, "fine"},
                                    {"Team É", "6", true, 8, "fine"},
                                    {"Default group", "", true, 7, "fine"},
                                    {"Zoë K (9)", "9", true, 6, "fine"},
                                    {"Nobody", "8", true, 1, "fine"}};
  const auto table = [&](bool done) {
    const auto if_done = [&](const char* grade) { return done ? grade : ""; };
    return head + row("Participant 5,Cy Ace", "Team É", if_done("8")) +
           row("Participant 6,Di Ace", "Team A", if_done("9")) +
           row("Participant 7,Eve Ace", "Team A", if_done("9")) +
           row("Participant 8,Fay Ace", "Default group", if_done("7")) +
           row("Participant 9,Zoe\xcc\x88 K", "Team A", if_done("6")) +
           row("Participant 10,Gus Ace", "Team B", "");
  };
  const Worksheet::Filled filled = Worksheet(table(false), "sheet.csv").filled(teams, 20);
  EXPECT_EQ(filled.text, table(true));
  EXPECT_THAT(filled.strays, ElementsAre("Nobody"));
  const auto pages = Worksheet(table(false), "sheet.csv").pages(teams, [](const GradeRow& learner) {
    return learner.name;
  });
  EXPECT_EQ(pages.size(), 4U);
  EXPECT_THAT(pages.at("Team A"), ElementsAre("Participant_6_assignsubmission_file_/report.html",
                                              "Participant_7_assignsubmission_file_/report.html"));
  EXPECT_THAT(pages.at("Zoë K (9)"), ElementsAre("Zoë K (9)"));
  EXPECT_FALSE(pages.contains("Nobody"));
}

// Groups whose names differ in letters that a file's name may lose, and a learner who is called like a group.
TEST(Worksheet, a_name_that_is_alike_takes_nobodys_grade) {
  const std::string head =
      "Identifier,Full name,Group,Grade,Maximum Grade,Grade can be changed,Feedback comments\n";
  const auto row = [](const char* who, const char* group, const char* grade) {
    return fmt::format("{},{},{},20,Yes,{}\n", who, group, grade, *grade == 0 ? "" : "fine");
  };
  const std::vector<GradeRow> rows{
      {"Team α", "101", true, 1, "fine"},   {"Team β", "102", true, 2, "fine"},
      {"Lab (1)", "103", true, 3, "fine"},  {"Lab (2)", "104", true, 4, "fine"},
      {"Team A (9)", "9", true, 5, "fine"}, {"Team A (105)", "105", true, 6, "fine"},
      {"Row_1", "106", true, 7, "fine"},    {"Tür", "107", true, 8, "fine"},
      {"Tor", "108", true, 9, "fine"}};
  const auto table = [&](bool done) {
    const auto if_done = [&](const char* grade) { return done ? grade : ""; };
    return head + row("Participant 1,A", "Team α", if_done("1")) +
           row("Participant 2,B", "Team β", if_done("2")) +
           row("Participant 3,C", "Lab (1)", if_done("3")) +
           row("Participant 4,D", "Lab (2)", if_done("4")) +
           row("Participant 5,E", "Team A", if_done("6")) +
           row("Participant 9,Team A", "Team A", if_done("5")) +
           row("Participant 10,F", "Row 1", "") + row("Participant 11,G", "Row-1", "") +
           row("Participant 12,H", "Tu\xcc\x88r", if_done("8")) +
           row("Participant 13,I", "T/or", if_done("9"));
  };
  const Worksheet::Filled filled = Worksheet(table(false), "sheet.csv").filled(rows, 20);
  EXPECT_EQ(filled.text, table(true));
  EXPECT_THAT(filled.unclear, ElementsAre("Row 1", "Row-1"));
  EXPECT_THAT(filled.strays, ElementsAre("Row_1"));
  EXPECT_THAT(Worksheet(table(false), "sheet.csv")
                  .pages(rows, [](const GradeRow& learner) { return learner.name; })
                  .at("Team A (105)"),
              ElementsAre("Participant_5_assignsubmission_file_/report.html"));
}

}  // namespace
}  // namespace grader::platforms
