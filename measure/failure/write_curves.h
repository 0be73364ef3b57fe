#pragma once

#include "grader/check/language/curve.h"

#include <functional>
#include <string>

namespace measure::failure {

// Measures the curves of this program's task, or only the named curve, and writes them as JSON: a
// list of objects with the texts of the chart, the places, and the results there. An error that is
// not a number is null. `begin` is called before each place. Throws pt::Error if the curve does not
// exist or the file cannot be written.
void write_curves(const std::string& path, const std::string& only,
                  const grader::check::CurveSettings& settings, const std::function<void()>& begin);

}  // namespace measure::failure
