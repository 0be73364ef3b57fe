#pragma once

#include "writeup/measure/candidates.h"
#include "writeup/measure/results.h"

#include <functional>

namespace writeup::measure {

// Measures the candidates of a task for so many seconds by the clock. Their workers take turns in short batches,
// and each is compared with the batches of the reference before and after its own, so that what else the
// machine does slows all of them. `progress` gets the part done. Throws pt::Error if the reference itself cannot be measured.
Results measure_contest(const Contest& contest, grader::sandbox::Tier tier, double seconds,
                        const std::function<void(double)>& progress);

}  // namespace writeup::measure
