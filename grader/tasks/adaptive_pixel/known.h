#pragma once

#include "grader/tasks/adaptive_pixel/inputs.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <fmt/format.h>

// Pixels whose right number of samples does not depend on the details of sigma.

namespace grader::check::adaptive_pixel_inputs {

// A pixel and its right number of samples, if this number does not depend on the details of sigma;
// else 0.
struct Known {
  Case pixel;
  int samples = 0;
};

inline void showValue(const Known& known, std::ostream& out) { showValue(known.pixel, out); }

inline rc::Gen<Known> maybe_known() {
  return rc::gen::exec([] {
    switch (*whole(0, 2)) {
      case 0: {
        const Case c = *constant();
        return Known{c, c.settings.batch};
      }
      case 1: {
        const Case c = *red_and_green();
        return Known{c, c.settings.max_samples};
      }
      default:
        return Known{*noise(), 0};
    }
  });
}

// Two values around 1, in turn.
inline Case in_turn(double spread, const AdaptiveSettings& settings) {
  return pixel(fmt::format("{:.6g} and {:.6g} in turn", 1 - spread, 1 + spread), settings,
               below_and_above_1(spread));
}

// Two values around 1, in turn. The condition holds after `batches` batches, and clearly not after
// fewer: for the sigma that divides by n and the one that divides by n - 1. The tolerance is in
// [low, high], or less if as many samples as that need a smaller one.
inline rc::Gen<Known> narrow_after(int batches, double low, double high) {
  return rc::gen::exec([=] {
    const int batch = high > 0.5 ? 4 : 2 * *whole(2, 4);
    const double samples = (batches - 0.4) * batch;
    const double most = std::min(high, 1.86 / std::sqrt(samples));
    const double tolerance = *magnitude(std::min(std::max(low, least_tolerance()), most), most);
    const double spread = tolerance * std::sqrt(samples) / 1.96;
    const int count = batches * batch;
    return Known{in_turn(spread, {count + *whole(1, 2 * count), batch, tolerance}), count};
  });
}

// Two values around 1, in turn. The condition needs twenty times fewer samples than a batch or
// twenty times more than the maximum, so that even a wrong sigma gives the right count.
inline rc::Gen<Known> far_from_the_threshold() {
  return rc::gen::exec([] {
    const bool narrow = *rc::gen::arbitrary<bool>();
    const int batch = *rc::gen::oneOf(whole(2, 20), whole(30, 300));
    const int most = *whole(2, 5) * batch + *whole(0, 1);
    const double tolerance = narrow ? *real(0.5, 1) : *magnitude(least_tolerance(), 5e-3);
    const double samples = narrow ? batch / 20.0 : 20.0 * most;
    const double spread = std::min(0.9, tolerance * std::sqrt(samples) / 1.96);
    return Known{in_turn(spread, {most, batch, tolerance}), narrow ? batch : most};
  });
}

// Pixels whose interval is almost as wide as the limit.

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
