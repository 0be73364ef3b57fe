#pragma once

#include "grader/report/platforms.h"
#include "grader/report/read_csv.h"

#include <cstddef>
#include <string>
#include <vector>

namespace grader::report {

// The offline grading worksheet that Moodle exports for an assignment (MoodleDocs, "Assignment settings"): a table with a
// row per participant, of whom some have handed in nothing.
class Worksheet {
 public:
  // `path` is for the sentences. Throws pt::Error, with the line, if the text is not a worksheet, or is in
  // another language than English.
  Worksheet(std::string text, std::string path);

  struct Filled {
    std::string text;
    std::size_t locked = 0;  // learners who keep the grade that they have: Moodle has locked it
    std::vector<std::string> strays;  // names of learners who are not in the worksheet
  };

  // Puts in the grade and the comment of each learner, by the participant's number. All else stays as it is, byte for byte: rows of
  // participants who handed in nothing, the grade of somebody who was not judged, and the times by which Moodle
  // sees whether a grade was changed since. Throws pt::Error if Moodle's maximum is not `max_points`.
  Filled filled(const std::vector<GradeRow>& rows, int max_points) const;

 private:
  std::size_t column(const char* name, bool must_be = true) const;
  void check(const CsvRow& row) const;
  void check_maximum(const CsvRow& row, int max_points) const;
  [[noreturn]] void fail(int line, const std::string& what) const;

  std::string text_, path_;
  CsvTable table_;  // the first row names the columns
  std::size_t identifier_, grade_, maximum_, can_change_, comment_;
};

// Throws pt::Error if the file is missing, or is not a worksheet.
Worksheet read_worksheet(const std::string& path);

}  // namespace grader::report
