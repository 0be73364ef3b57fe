#pragma once

#include "grader/report/read_csv.h"
#include "grader/service/platforms/platforms.h"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace grader::platforms {

// The offline grading worksheet that Moodle exports for an assignment (MoodleDocs, "Assignment
// settings"): a table with a row per participant, also for those without a submission.
class Worksheet {
 public:
  // `path` is for messages. Throws pt::Error, with the line, if the text is not a worksheet, or not
  // in English.
  Worksheet(std::string text, std::string path);

  struct Filled {
    std::string text;
    std::size_t locked = 0;            // learners whose grade Moodle has locked
    std::vector<std::string> strays;   // names of learners who are not in the worksheet
    std::vector<std::string> unclear;  // names of groups that may be those of several submissions
  };

  // Fills in each learner's grade and comment, by the participant's number. The number in the name
  // of a group's files is the group's: in a table with groups, where the participant with this
  // number has another name, everybody in the group with that name gets the grade. A group whose name
  // fits two submissions, or none better than another group's name does, gets nothing, and is named.
  // Everything else stays the same, byte for byte: rows of participants without a submission, the
  // grade of a learner who was not judged, and the times that show Moodle whether a grade was changed since. Throws
  // pt::Error if Moodle's maximum is not `max_points`.
  Filled filled(const std::vector<GradeRow>& rows, int max_points) const;

  // The paths by which Moodle gives each learner's page to participants, by the learner's name:
  // a group's to each member. `path_of` has the path by which the learner alone gets it. A learner
  // who is not in the worksheet has none.
  std::map<std::string, std::vector<std::string>> pages(
      const std::vector<GradeRow>& rows,
      const std::function<std::string(const GradeRow&)>& path_of) const;

  // The times of the last change of a submission, as they are written, by the learner's name: a group has one of each member.
  std::map<std::string, std::vector<std::string>> modified(const std::vector<GradeRow>& rows) const;

 private:
  // A participant's row, and who hands in for this participant.
  struct Match {
    const report::CsvRow* row = nullptr;
    const GradeRow* learner = nullptr;
    bool alone = false;  // not as a member of a group
  };
  struct Matches {
    std::vector<Match> all;
    std::vector<std::string> unclear;  // as in Filled
  };
  Matches matches(const std::vector<GradeRow>& rows) const;
  std::size_t column(const char* name, bool must_be = true) const;
  void check(const report::CsvRow& row) const;
  void check_maximum(const report::CsvRow& row, int max_points) const;
  bool is_of(const GradeRow& learner, const report::CsvRow& row) const;
  [[noreturn]] void fail(int line, const std::string& what) const;

  std::string text_, path_;
  report::CsvTable table_;  // the first row names the columns
  std::size_t identifier_, grade_, maximum_, can_change_, comment_, name_, group_, modified_;
};

// Throws pt::Error if the file is missing, or is not a worksheet.
Worksheet read_worksheet(const std::string& path);

}  // namespace grader::platforms
