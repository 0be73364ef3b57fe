#pragma once

#include "grader/calls.h"
#include "measure/calls/message.h"

#include <cstdint>
#include <functional>

// The subject of a worker's measurement: one case of the task that is linked here, on its own
// inputs. The inputs are the same in every worker.

namespace measure::calls {

struct Subject {
  int calls = 0;               // calls per pass
  std::function<void()> pass;  // calls the task on all inputs
  std::function<Found(std::uint64_t seed)> find;
};

// measure_<slug>(case) for each task: defined in grader/tasks/<slug>/measure.cpp. The cases are those of its task.json.
#define FIRSTLIGHT_DECLARE(slug, CALL, DRAW) Subject measure_##slug(int of_case);
FIRSTLIGHT_TASKS(FIRSTLIGHT_DECLARE, , )
#undef FIRSTLIGHT_DECLARE

}  // namespace measure::calls
