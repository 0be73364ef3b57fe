#pragma once

#include "measure/calls/message.h"

#include <string>
#include <vector>

namespace measure::calls {

// The quality of a task that is measured besides its time.
enum class Kind {
  exact,      // its largest error, against a closed form in long double
  estimator,  // its noise, and its mean against a closed form
  tree,       // the boxes and primitives that a ray tests
};

// The measurements of one task: the word "measured" of its task.json.
struct About {
  std::string slug;
  Kind kind = Kind::exact;
  std::vector<std::string> cases;   // "leaf 4"; a single case has no name
  bool one_front = false;           // the cases are settings to choose from, not other inputs
  bool chooses_samples = false;     // the task itself chooses its number of samples
  std::vector<std::string> errors;  // kinds of error, at most kMaxErrors; the first one is charted
  std::string inputs;               // a sentence
};

// All tasks, in the order of the course.
const std::vector<About>& tasks();

}  // namespace measure::calls
