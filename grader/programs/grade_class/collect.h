#pragma once

#include "grader/programs/grade_class/one.h"
#include "grader/programs/grade_class/plan.h"
#include "grader/report/class_page.h"
#include "grader/report/platforms.h"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

// The files for the class as a whole.

namespace grader::programs {

// Collects outcomes, one for each submission of the plan, and writes
//   class.csv                a line per submission: who, points, and the state and points of every task (RFC 4180)
//   class.html               grader/report/class_page.h
//   canvas.csv, moodle.csv   what the learning platforms take back; of Moodle its worksheet, if the plan names it
//   gradescope.csv           the same by name and ID; Gradescope takes no table back
//   feedback.zip             every page, under the path by which its platform knows it
//   compare.csv, .html       if the plan names an earlier grading: grader/report/compare_page.h
//   names.csv                of an anonymous class: who is who
// Results are not kept: a class of a thousand needs little memory.
class Collector {
 public:
  Collector(const judge::Config& config, const ClassPlan& plan, std::string out);

  // The outcome for submission i. Now and then writes the table of what is there so far.
  void add(std::size_t i, const Graded& graded);

  // Writes everything. Returns the paths.
  std::vector<std::string> write();

  // After that, sentences to be read: who gains and who loses, and whom the worksheet leaves out.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  void write_table();
  std::vector<std::string> write_returns();
  std::string moodle_table(const std::vector<report::GradeRow>& rows);

  const judge::Config& config_;
  const ClassPlan& plan_;
  std::string out_;
  std::vector<std::string> lines_;  // of the table
  std::vector<report::GradeRow> for_platforms_;
  report::ClassPage page_;
  int max_points_ = 0;
  std::vector<std::string> remarks_;
  std::chrono::steady_clock::time_point next_table_{};
};

}  // namespace grader::programs
