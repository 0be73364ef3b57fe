#pragma once

#include "grader/check/cause.h"
#include "grader/mistakes/answers.h"
#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

// A battery: a fixed list of calls of one task, and the numbers that the task answers. Different
// mistakes give different answers, so that the answers of a submission that fails can name its
// mistake (grader/mistakes/naming.h). The inputs are always the same; only what a task draws at
// random depends on the seed. Numbers that the contract leaves free, such as the depth of a tree,
// are no answers: right solutions of any kind answer alike.

namespace grader::mistakes {

// Thrown by a call that came to nothing, while a battery runs.
struct CallEnded {
  check::Cause cause;
};

// How the batteries are run: what a submission is asked, and, with more draws, what is kept.
struct BatterySettings {
  std::uint64_t seed = 1;  // of all draws
  int draws = 1;           // how many times the usual number
};

class Battery {
 public:
  using Numbers = std::vector<double>;
  // The numbers that n calls gave, one list each; all lists have the same length.
  using Draws = std::function<std::vector<Numbers>(int n, std::uint64_t seed)>;
  using Colors = std::function<std::vector<pt::Rgb>(int n, std::uint64_t seed)>;

  explicit Battery(const BatterySettings& settings) : settings_(settings) {}

  // A call whose answer depends on nothing random.
  void ask(const std::function<Numbers()>& call);

  // The mean of each number over n draws.
  void mean(int n, const Draws& draw);

  // Of an estimator: the mean of each channel, the standard deviation over the mean, and how many
  // of the draws are black.
  void estimate(int n, const Colors& draw);

  const Answers& answers() const { return answers_; }

 private:
  void record(const std::function<Answer()>& call);

  BatterySettings settings_;
  Answers answers_;
  int timeouts_ = 0;
};

// Defined for every task in the file with its name: a program has one.
void run_battery(Battery& battery);

// For the calls of a battery.
Battery::Numbers numbers(pt::Vec3 v);
Battery::Numbers numbers(pt::Rgb c);
inline double flag(bool condition) { return condition ? 1 : 0; }

}  // namespace grader::mistakes
