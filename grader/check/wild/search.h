#pragma once

#include "grader/check/generators/random_numbers.h"
#include "grader/check/language/property.h"
#include "grader/explain/explain.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Calls in wild scenes as an input of promises. A file is plain if (nearly) all calls of the kind that its promises make are
// explained. In a plain file a wild call that is not explained is a second rule: it fails the promise that it breaks.
// A file that is not plain (another density, its own survival) is judged by means alone. A file whose values are all off by less than a
// hundredth is plain: it has an error in the formula, and no formula of its own.

namespace grader::check {

using Explanations = std::vector<explain::Explanation>;

// One wild input of a task.
class WildInput {
 public:
  virtual ~WildInput() = default;
  // The explanations of n calls. Empty where calls are not recorded.
  virtual Explanations ask(int n, std::uint64_t seed) const = 0;
  virtual std::vector<std::shared_ptr<const WildInput>> smaller() const = 0;
  virtual std::string text() const = 0;
  virtual int samples() const = 0;  // that one call takes, about
};
using WildPointer = std::shared_ptr<const WildInput>;

struct WildTask {
  // The explanations of calls in the scenes of the promises. `seed` is that of the run.
  std::function<Explanations(std::uint64_t seed)> usual;
  std::function<WildPointer(RandomNumbers& random)> draw;  // null if the draw makes no call
  int inputs = 7000;
  int calls = 3;  // of each input
};

// The share of calls that have to be explained in a plain file.
inline constexpr double kPlain = 0.999;

// The counts that say whether a file is plain. A habit is a rule for random numbers that most files keep, but need not (explain::Fault).
struct Plainness {
  int calls = 0, explained = 0, with_habit = 0;

  void add(const explain::Explanation& call);

  bool is_plain() const { return calls > 0 && explained >= kPlain * calls; }
  bool keeps_habit() const { return calls > 0 && with_habit >= kPlain * calls; }
  bool is_explained() const { return calls > 0 && with_habit == calls; }
};

struct WildFailure {
  WildPointer input;
  std::uint64_t seed = 0;
  explain::Explanation why;
  int inputs_before = 0;
};

struct WildResult {
  Plainness wild;                      // no wild calls if the file is not plain
  std::optional<WildFailure> failure;  // the first wild call that breaks a promise, made smaller
};
WildResult make_wild_calls(const WildTask& task, const Plainness& usual, std::uint64_t seed);

// From now on no wild calls are made. This is for work in the skeleton of a course, where rays start at a fixed distance: it is shown
// scenes of one size, and wild scenes have parts of very different sizes.
void never_wild();

// The current promise fails if a wild call breaks it. The calls are made once for all promises of the task. A file that has
// failed before is not asked: it has its sentence.
void expect_explained(const WildTask& task);

// Returns whether a mean would say nothing more: all usual calls of this file are explained, and so are some calls in the scene of
// the mean. `ask` makes n of them, each of which takes about so many samples. A result then follows from random numbers that the
// judge knows, by the formula of the contract.
bool needs_no_mean(const WildTask& task, const std::function<Explanations(int n)>& ask,
                   int samples);

}  // namespace grader::check
