#pragma once

#include "grader/judge/builder.h"
#include "grader/judge/grade.h"

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace writeup::stability {

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
  bool methods = true;     // those that the curves are about
  bool variants = true;    // every right solution of the task's folder too
  double effort = 1;       // times the usual number of cases
  bool coarse = false;     // every third place only
  grader::judge::GradeRequest judge;
};

// A place of a curve, as a line has it. `error` is NaN without a number; `noise` is the standard error
// of a mean, 0 for other errors.
struct Point {
  double place = 0, error = 0, noise = 0;
  int cases = 0, without = 0;
  std::string reason;
};

// A promise of the contract as the corners of its upper edge, from left to right. All places of the
// curve between the first corner and the last are among them.
struct Promised {
  struct Corner {
    double place = 0, limit = 0;
  };
  std::vector<Corner> corners;
  bool bonus = false;
};

// A curve of a task, with the points of each line: none for lines that could not be measured.
struct Chart {
  std::string slug, name, title, input, error, source;
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

// Returns whether it is in the chart, with a name or as one of the other right solutions. Methods of
// other charts are not.
bool is_shown(const Charts& charts, const Chart& chart, std::size_t line);

// The first place at which a line breaks a promise, by a larger error or a case without a number.
struct BrokenPromise {
  std::size_t line = 0;
  bool bonus = false;
  double place = 0;
};

// Broken promises of the lines of the chart. Those without a name may lack a bonus. The mean of random numbers may be some standard errors above the limit by chance.
std::vector<BrokenPromise> broken_promises(const Charts& charts, const Chart& chart);

// A search for bad inputs of a task (grader/check/bad_inputs.h), by the reference or the submission.
struct Search {
  double minutes = 1;
  std::string file;  // keeps what was found; the next search goes on from there
};

// The answer of a task's program about one line as JSON, an empty array where it has none.
struct Answered {
  nlohmann::json answer;
  std::string unusable;  // the reason why the line cannot be used; else empty
};

// Searches, and returns what was found. Throws pt::Error where nothing can be measured.
Answered search_task(const grader::judge::Config& config, const grader::judge::TaskConfig& task,
                     const Request& request, const Search& search, const CurveLine& line);

// A hash of all that the charts of a task depend on, besides the request's numbers.
std::string charts_hash(const grader::judge::Config& config, const grader::judge::TaskConfig& task,
                        const Request& request);

// Measures all curves of a task. The code of a submission runs in a box only: the answer tells if it
// hangs, crashes or does not compile. Throws pt::Error where nothing can be measured. `progress` is
// called with the part that is done, from one thread at a time.
Charts measure_task(const grader::judge::Config& config, const grader::judge::TaskConfig& task,
                    const Request& request, const std::function<void(double)>& progress);

}  // namespace writeup::stability
