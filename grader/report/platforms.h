#pragma once

#include <string>
#include <vector>

namespace grader::report {

// One learner's grade, on its way back to the learning platform.
struct GradeRow {
  std::string name;
  std::string id;       // the platform's
  bool judged = false;  // else no points are claimed
  int points = 0;       // with bonus points
  std::string comment;  // one sentence
};

// The table that Canvas imports under Grades (Instructure's guide "How do I import grades in the Gradebook?"): a
// column of points named `assignment`.
std::string canvas_csv(const std::vector<GradeRow>& rows, const std::string& assignment,
                       int max_points);

// The table that Moodle takes as an offline grading worksheet (MoodleDocs, "Assignment settings"): grade and
// feedback by the participant's number. Moodle refuses a grade above the assignment's maximum: points
// beyond `max_points` stay in the comment.
std::string moodle_csv(const std::vector<GradeRow>& rows, int max_points);

// A table by name and ID, for Gradescope, which has no import of grades: to copy from.
std::string gradescope_csv(const std::vector<GradeRow>& rows, int max_points);

}  // namespace grader::report
