#pragma once

#include "grader/service/classes/one.h"
#include "grader/service/classes/plan.h"
#include "grader/service/platforms/class_page.h"
#include "grader/service/platforms/likeness.h"
#include "grader/service/platforms/platforms.h"

#include <chrono>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

// The files for the class as a whole.

namespace grader::classes {

// Collects outcomes, one for each submission of the plan, and writes
//   class.csv                a line per submission: who, points, the state and points of every task, and the grade that
//                            goes back, which lateness and points by hand may change (RFC 4180)
//   class.html               grader/service/platforms/class_page.h
//   canvas.csv, moodle.csv   for the learning platforms; Moodle's worksheet, if the plan names it
//   gradescope.csv           the same by name and ID, for reading: Gradescope imports no table
//   feedback.zip             every page, under the path that its platform knows
//   likeness.html            grader/service/platforms/likeness.h, unless the plan leaves it out
//   likeness/NAME/           the task files of each submission, as JPlag wants them, with that page
//   compare.csv, .html       if the plan names an earlier grading: grader/service/platforms/compare_page.h
//   names.csv                for an anonymous class: who is who
// Puts the grade and the files that were handed in on each learner's page. Results are not kept: a class of a thousand needs little
// memory.
class Collector {
 public:
  Collector(const build::Config& config, const ClassPlan& plan, std::string out);

  // Adds the outcome of submission i. Now and then writes the table of the outcomes so far.
  void add(std::size_t i, const Graded& graded);

  // Writes everything. Returns the paths.
  std::vector<std::string> write();

  // After that, sentences to print: who gains and loses points, and who is not in the worksheet.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  std::string note_on(std::size_t i, const Graded& graded) const;
  void add_files(const Graded& graded);
  Grade grade(std::size_t i, const Graded& graded) const;
  void finish_page(const Graded& graded, const Grade& grade) const;
  void write_table();
  std::vector<std::string> write_returns();
  std::map<std::string, std::vector<std::string>> pages_of_moodle() const;
  std::string moodle_table(const std::vector<platforms::GradeRow>& rows);

  const build::Config& config_;
  const ClassPlan& plan_;
  std::string out_;
  std::vector<std::string> lines_;  // of the table
  std::vector<platforms::GradeRow> for_platforms_;
  platforms::ClassPage page_;
  platforms::Likeness likeness_;
  int max_points_ = 0;
  std::map<std::size_t, Override> overrides_;
  std::map<std::size_t, std::string> equals_;  // of submissions with equal files: whose
  std::vector<std::string> remarks_;
  std::chrono::steady_clock::time_point next_table_{};
};

}  // namespace grader::classes
