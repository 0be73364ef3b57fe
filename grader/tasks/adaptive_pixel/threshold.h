#pragma once

#include "grader/tasks/adaptive_pixel/inputs.h"

#include <cmath>

#include <fmt/format.h>

// Pixels whose interval is almost as wide as the limit.

namespace grader::check::adaptive_pixel_inputs {

enum class Side { narrow, wide };

// The half interval is 3e-5 of the limit narrower or wider than the limit, where the contract
// allows 2e-5. This is after the first batch if sigma divides by n, and after the second batch if
// it divides by n - 1. In the latter case, a sigma that divides by n is done after the first batch.
//
// Both batches have values mean (1 - s) and mean (1 + s) in turn, so that n sigma^2 is a sum of
// s^2. The third batch is constant, and ends the pixel. All numbers are so large that the
// difference is clear in absolute terms, too.
inline rc::Gen<Case> at_the_threshold(int batch, bool divides_by_n, Side side) {
  return rc::gen::exec([=] {
    const double mean = *magnitude(1e3, 1e6), first = *real(0.2, 0.4);
    const double off = side == Side::narrow ? 1 - 3e-5 : 1 + 3e-5;
    const double by_n = 1.0 / batch, by_less = 1.0 / (batch - 1);
    const double between = (by_n + by_less) / 2;  // the square of limit / 1.96, in units of first^2
    const double second =
        first * std::sqrt(off * off * between * 2 * (2 * batch - 1) - 1);  // if divided by n - 1
    const double limit = 1.96 * first * std::sqrt(divides_by_n ? by_n / (off * off) : between);
    return pixel(
        fmt::format("{:.6g} and {:.6g} in turn, in the second batch {:.6g} and {:.6g}, then {:.4g}",
                    mean * (1 - first), mean * (1 + first), mean * (1 - second),
                    mean * (1 + second), mean),
        {5 * batch, batch, limit}, [=](int i, double) {
          const double spread = i < batch ? first : i < 2 * batch ? second : 0;
          return pt::gray(mean * (1 + (i % 2 == 0 ? -spread : spread)));
        });
  });
}

}  // namespace grader::check::adaptive_pixel_inputs
