#pragma once

#include "measure/calls/candidates.h"
#include "measure/calls/results.h"

#include <functional>

namespace measure::calls {

// Measures the candidates of a task for `seconds` by the clock. Workers take turns in short
// batches, compared with the reference's before and after, so that other load slows both.
// `progress` gets the part done. Throws pt::Error if the reference itself cannot be measured.
Results measure_contest(const Contest& contest, grader::sandbox::Tier tier, double seconds,
                        const std::function<void(double)>& progress);

}  // namespace measure::calls
