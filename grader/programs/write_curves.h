#pragma once

#include "grader/check/curve.h"

#include <functional>
#include <string>

namespace grader::programs {

// Measures the curves of this program's task, or only the one of this name, and writes them as JSON:
// a list of objects with all that a chart says, the places, and what was measured there. An error
// that is no number is null. `begin` is called before each place. Throws pt::Error if there is no such
// curve or the file cannot be written.
void write_curves(const std::string& path, const std::string& only,
                  const check::CurveSettings& settings, const std::function<void()>& begin);

}  // namespace grader::programs
