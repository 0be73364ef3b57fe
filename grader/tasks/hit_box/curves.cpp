#include "grader/check/language/curve.h"
#include "grader/check/language/property.h"
#include "grader/tasks/hit_box/exact.h"
#include "grader/tasks/hit_box/inputs.h"

#include <limits>

namespace grader::check {
namespace {

using namespace hit_box_inputs;

double missed(const Case& c) { return call(c).has_value() ? 0 : 1; }

CURVE(hit_box, edges_and_corners) {
  return {.title = "Rays at edges and corners of the boxes of triangles",
          .input = "distance from the world's origin, in sizes of the box",
          .error = "share of rays that miss",
          .source = "Ize 2013, Robust BVH Ray Traversal",
          .places = by_factors(1, 1e8, 9),
          .promised = {{.first = 1, .last = 1e8, .bonus = true}},
          .methods = {{"methods/slabs", "plain slabs"},
                      {"right/some_ulps_wider", "slabs a little wider"},
                      {"methods/slabs", "plain slabs, single precision", true}},
          .statistic = Statistic::mean,
          .cases = 1000,
          .measure = [](double away) { return missed(*grazing(away)); }};
}

CURVE(hit_box, thin) {
  return {.title = "A thin box, met from either side",
          .input = "thickness over diagonal",
          .error = "share of rays that miss",
          .source = "a box of one triangle may have no thickness at all",
          .places = by_factors(1e-1, 1e-20, 20),
          .promised = {{1e-20, 1e-1}},
          .methods = {{"methods/slabs", "plain slabs"},
                      {"wrong/least_thickness", "thin boxes dropped"},
                      {"methods/slabs", "plain slabs, single precision", true}},
          .statistic = Statistic::mean,
          .measure = [](double thickness) { return missed(*at_a_sheet(thickness)); }};
}

// Logarithmic places have no 0, so the last place represents 0, with either sign.
constexpr double kSmallest = 1e-315, kZero = std::numeric_limits<double>::denorm_min();
// 1 / kInvertible is finite.
constexpr double kInvertible = 1e-294;

std::vector<double> down_to_zero() {
  std::vector<double> places = by_factors(1, kSmallest, 16);
  places.push_back(kZero);
  return places;
}

CURVE(hit_box, in_a_side) {
  return {.title = "A ray that starts in a side of the box and goes inwards",
          .input = "component of the direction across the side; the last place is 0 and -0",
          .error = "share of rays that miss",
          .source = "1 / d overflows, and 0 times infinity is not a number",
          .places = down_to_zero(),
          .promised = {{1, kInvertible}, {.first = kSmallest, .last = kZero, .bonus = true}},
          .methods = {{"wrong/plain_slabs_in_a_side", "min and max of NaN"},
                      {"wrong/sign_of_minus_zero", "swapped where d < 0"},
                      {"right/special_case_and_wider", "parallel rays apart"},
                      {"wrong/short_components_are_parallel", "short components taken as 0"}},
          .statistic = Statistic::mean,
          .measure = [](double across) {
            Case c = *along_axes(false);
            const int axis = *whole(0, 2);
            const bool upper = *whole(0, 1) == 1;
            c.ray.origin[axis] = upper ? c.box.max[axis] : c.box.min[axis];
            c.ray.direction[axis] = upper ? -across : across;
            if (across == kZero) c.ray.direction[axis] = zero();
            return expected(c).is_miss() ? 0 : missed(c);
          }};
}

}  // namespace
}  // namespace grader::check
