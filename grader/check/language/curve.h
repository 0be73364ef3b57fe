#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

// Shows where a method fails. A curve shows how the error of a task grows while its input gets harder: a
// sphere farther away, a thinner triangle, a smaller light. A promise of the contract is one place of a
// curve, and both are measured by the same functions. The curves of a task are in
// grader/tasks/<task>/curves.cpp:
//
//   CURVE(hit_sphere, far_away) {
//     return {.title = "A sphere far away", ...
//             .measure = [](double distance) { return off_the_sphere(*aimed_from(distance)); }};
//   }

namespace grader::check {

// The number that is drawn for many cases.
enum class Statistic {
  largest,  // of an error
  mean,     // of 0 and 1: the share of wrong cases
  median,   // of numbers that each come from many calls
  bias,     // of numbers with a sign: the size of their mean, with its standard error
};

// Another method for the task, drawn together with the reference. It is a file in the folder of the
// task: a right solution, or in methods/ a form of it whose arithmetic type is REAL.
struct Method {
  std::string file;     // "methods/quadratic"; "wrong/midpoint" is a mistake of mistakes.txt
  std::string title;    // "quadratic formula"
  bool single = false;  // REAL is float
};

// A limit that is the same at every place.
std::function<double(double place)> at_most(double limit);

// A promise of the contract: an error of at most `limit` at places from `first` to `last`.
struct Promised {
  double first = 0, last = 0;  // in any order; they may be the same
  std::function<double(double place)> limit = at_most(0);
  bool bonus = false;  // a bonus, which right solutions may break
};

struct Curve {
  std::string title;
  std::string input;           // the meaning of a place, with its unit
  std::string error;           // the measured quantity, with its unit
  std::string source;          // who described this, or the reason for it
  std::vector<double> places;  // from easy to hard, above 0
  std::vector<Promised> promised;
  std::vector<Method> methods;
  Statistic statistic = Statistic::largest;
  int cases = 200;                                  // at each place
  std::function<double(double place)> theory = {};  // the error by a formula, if there is one
  // Runs one case: draws from generators, calls the task, and returns its error, at least 0. A case
  // may fail (expect) if it has no error, for example without a hit.
  std::function<double(double place)> measure;
};

// The measurement at one place.
struct MeasuredPlace {
  double place = 0;
  double error = 0;    // NaN if no case has given a number
  double noise = 0;    // the standard error of a bias; 0 for other statistics
  int cases = 0;       // all cases
  int without = 0;     // cases without a finite number: no hit, NaN, a crash, a time-out
  std::string reason;  // of the first case without a number
  bool ended = false;  // the code crashed, or gave no answer in time
};

struct CurveSettings {
  std::uint64_t seed = 1;
  double effort = 1;     // times the usual number of cases
  bool coarse = false;   // only every third place
  double seconds = 1e9;  // limit for the whole curve; later places have no case
};

// `begin` is called before each place.
std::vector<MeasuredPlace> measure(const Curve& curve, const CurveSettings& settings,
                                   const std::function<void()>& begin);

struct NamedCurve {
  std::string task;  // the slug
  std::string name;
  Curve curve;
};

// The curves of the task that this program has, in the order of their file.
const std::vector<NamedCurve>& curves();

// `count` places from `first` to `last`, by equal factors.
std::vector<double> by_factors(double first, double last, int count);

// Used by CURVE.
bool keep_curve(const char* task, const char* name, Curve (*make)());

}  // namespace grader::check

#define CURVE(task, name)                                               \
  static ::grader::check::Curve curve_##task##_##name();                \
  static const bool kept_##task##_##name =                              \
      ::grader::check::keep_curve(#task, #name, curve_##task##_##name); \
  static ::grader::check::Curve curve_##task##_##name()
