#pragma once

#include "grader/service/build/builder.h"
#include "grader/service/judging/grade.h"

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace measure::failure {

// One implementation of a task: a line in each of its charts.
struct CurveLine {
  enum class Kind { reference, submission, method, variant };

  Kind kind = Kind::reference;
  std::string title;
  std::string file;      // of the task's folder without ".cpp", for methods and variants
  bool single = false;   // its arithmetic type REAL is float
  std::string unusable;  // the reason why it cannot be measured; else empty
};

// The lines to measure, and the settings.
struct Request {
  std::string submission;  // a folder; empty: none
  bool methods = true;     // measure the methods that the curves are about
  bool variants = true;    // and every right solution of the task's folder
  double effort = 1;       // factor of the usual number of cases
  bool coarse = false;     // only every third place
  grader::judging::GradeRequest judge;
};

// A point of a line at a place of a curve. `error` is NaN if there is no number; `noise` is the
// standard error of a mean, 0 for other errors.
struct Point {
  double place = 0, error = 0, noise = 0;
  int cases = 0, without = 0;
  std::string reason;
  bool ended = false;  // the code crashed, or gave no answer in time
};

// A promise of the contract as the corners of its upper edge, from left to right. Every place of
// the curve between the first and the last corner is a corner.
struct Promised {
  struct Corner {
    double place = 0, limit = 0;
  };
  std::vector<Corner> corners;
  bool bonus = false;
};

// A curve of a task with the points of each line; no points for lines that could not be measured.
struct Chart {
  std::string slug, name, title, input, error, source;
  std::string drawn;  // "the largest of 200 cases": of the errors at a place; empty: the only one
  std::vector<Promised> promised;
  std::vector<double> theory;              // by place; none: empty
  std::vector<std::vector<Point>> points;  // by line
  std::vector<std::size_t> methods;        // the lines that it is about
};

// All charts of a task.
struct Charts {
  std::vector<CurveLine> lines;
  std::vector<Chart> charts;
};

// A name for files and texts: "reference", "yours", "quadratic_single".
std::string id_of(const CurveLine& line);

// Returns whether the chart is about this line: then it has a colour and a name there.
bool is_named(const Charts& charts, const Chart& chart, std::size_t line);

// Returns whether the line is in the chart, with a name or as another right solution. Methods of
// other charts are not in it.
bool is_shown(const Charts& charts, const Chart& chart, std::size_t line);

// A right mean is this many standard errors off once in fifteen thousand places.
inline constexpr double kErrors = 4;

// The first place at which a line breaks a promise: a larger error, or a case without a number.
struct BrokenPromise {
  std::size_t line = 0;
  bool bonus = false;
  double place = 0;
};

// Broken promises of the chart's lines; lines without a name may lack a bonus. A mean of random
// numbers may be kErrors standard errors above the limit by chance.
std::vector<BrokenPromise> broken_promises(const Charts& charts, const Chart& chart);

// Returns whether a submission is wrong or ends its program: it cannot be measured, breaks a promise of the
// contract, crashes at some place, or gives no answer there. A bonus need not be kept.
bool fails(const Charts& charts);

// A search for bad inputs (grader/check/language/bad_inputs.h) of the reference or the submission.
struct Search {
  double minutes = 1;
  std::string file;  // keeps the inputs found; the next search starts from them
};

// The JSON answer of a task's program about one line; an empty array if there is none.
struct Answered {
  nlohmann::json answer;
  std::string unusable;  // the reason why the line cannot be used; else empty
};

// Searches, and returns the inputs found. Throws pt::Error if nothing can be measured.
Answered search_task(const grader::build::Config& config, const grader::build::TaskConfig& task,
                     const Request& request, const Search& search, const CurveLine& line);

// A hash of everything that the charts of a task depend on, without the request's numbers.
std::string charts_hash(const grader::build::Config& config, const grader::build::TaskConfig& task,
                        const Request& request);

// Measures all curves of a task. A submission's code only runs in a box; if it hangs, crashes or
// does not compile, the answer says so. Throws pt::Error if nothing can be measured. `expect` is
// called once, before the curves are measured, with the seconds that they take: a look at every third
// place tells.
Charts measure_task(const grader::build::Config& config, const grader::build::TaskConfig& task,
                    const Request& request, const std::function<void(double)>& expect);

}  // namespace measure::failure
