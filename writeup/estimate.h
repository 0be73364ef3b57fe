#pragma once

#include "measure/renders/spec.h"

namespace writeup {

// Estimates the seconds on one processor of a render that was never made before.
double estimated_seconds(const measure::Spec& spec);

}  // namespace writeup
