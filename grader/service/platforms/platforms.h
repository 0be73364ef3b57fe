#pragma once

#include <string>
#include <vector>

namespace grader::platforms {

// One learner's grade, for the learning platform.
struct GradeRow {
  std::string name;
  std::string id;       // of the learning platform
  bool judged = false;  // false: no points are exported
  int points = 0;       // with bonus points
  std::string comment;  // one sentence
};

// Rows without an ID are left out of the tables of Canvas and Moodle.

// The table that Canvas imports under Grades (Instructure's guide "How do I import grades in the
// Gradebook?"). Its column of points is called `assignment`.
std::string canvas_csv(const std::vector<GradeRow>& rows, const std::string& assignment,
                       int max_points);

// The table that Moodle imports as an offline grading worksheet (MoodleDocs, "Assignment
// settings"): grade and feedback per participant's number. Moodle refuses a grade above the
// assignment's maximum, so points beyond `max_points` are only in the comment.
std::string moodle_csv(const std::vector<GradeRow>& rows, int max_points);

// A table by name and ID, to copy from: Gradescope cannot import grades.
std::string gradescope_csv(const std::vector<GradeRow>& rows, int max_points);

}  // namespace grader::platforms
