#pragma once

#include "grader/mistakes/answers.h"
#include "grader/results/results.h"
#include "pt/math/rgb.h"
#include "pt/math/vec3.h"
#include "pt/sampling/sampler.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

// A battery: a fixed list of calls of one task, and the numbers that the task returns. Different
// mistakes give different answers, so that the answers of a failing submission can name its mistake
// (grader/mistakes/naming.h). The inputs are always the same; only the random draws of a task
// depend on the seed. Numbers that the contract leaves free, for example the depth of a tree, are
// not part of the answers: all right solutions give the same answers.

namespace grader::mistakes {

// Thrown by a call that gives no answer, while a battery runs.
struct CallEnded {
  results::Cause cause;
  std::string how;  // in words; may be empty
};

// A battery is run with the usual number of draws for a submission, and with more draws for the answers
// that are kept.
struct BatterySettings {
  std::uint64_t seed = 1;  // for all draws
  int draws = 1;           // a multiple of the usual number
};

class Battery {
 public:
  using Numbers = std::vector<double>;
  // Returns the numbers of n calls, one list per call. All lists have the same length.
  using Draws = std::function<std::vector<Numbers>(int n, std::uint64_t seed)>;
  using Colors = std::function<std::vector<pt::Rgb>(int n, std::uint64_t seed)>;

  explicit Battery(const BatterySettings& settings) : settings_(settings) {}

  // Records a call whose answer is not random.
  void ask(const std::function<Numbers()>& call);

  // Records the mean of each number over n draws.
  void mean(int n, const Draws& draw);

  // Records an estimator: the mean of each channel, the standard deviation over the mean, and the
  // share of black draws.
  void estimate(int n, const Colors& draw);

  const Answers& answers() const { return answers_; }

 private:
  void record(const std::function<Answer()>& call);

  BatterySettings settings_;
  Answers answers_;
  int timeouts_ = 0;
  std::size_t crashes_ = 0;
};

// Each task defines it in the file with its name. A program contains one of these files.
void run_battery(Battery& battery);

// Helpers for the calls of a battery.
Battery::Numbers numbers(pt::Vec3 v);
Battery::Numbers numbers(pt::Rgb c);
inline double flag(bool condition) { return condition ? 1 : 0; }

// Makes two calls with the same sampler. Returns how far the first call moves it (0: not at all, 1: by
// one number, 2: further), and whether both return the same, as all calls must.
Battery::Numbers use_of_sampler(const std::function<Battery::Numbers(pt::Sampler& sampler)>& call);

}  // namespace grader::mistakes
