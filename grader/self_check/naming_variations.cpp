#include "grader/self_check/naming_variations.h"

namespace grader::self_check {

const std::vector<Variation>& naming_variations() {
  static const std::vector<Variation> all{
      {"hit_triangle", "cramers_rule", "if (all == 0)", "if (std::abs(all) < 1e-5)",
       "absolute_epsilon"},
      {"hit_triangle", "cramers_rule", "b0 < 0 || b1 < 0 || b2 < 0",
       "b1 < 0 || b1 > 1 || b2 < 0 || b2 > 1", "sum_of_weights_unchecked"},
      {"hit_triangle", "relative_guard", "normalize(n)", "n", "normal_not_normalised"},
      {"hit_triangle", "plane_then_edges", "t >= ray.t_min && t <= ray.t_max", "t >= 0",
       "only_in_front"},
      {"hit_sphere", "half_b",
       "  if (!(t >= ray.t_min && t <= ray.t_max)) t = (-half_b + root) / a;", "",
       "near_root_only"},
      {"hit_sphere", "distance_to_the_line", "t >= ray.t_min && t <= ray.t_max", "t >= ray.t_min",
       "t_max_forgotten"},
      {"hit_sphere", "half_b", "(ray.at(t) - sphere.center) / sphere.radius",
       "(sphere.center - ray.at(t)) / sphere.radius", "normal_inwards"},
      {"camera_ray", "matrix_form", "2 * y - 1", "1 - 2 * y", "y_flipped"},
      {"camera_ray", "matrix_form", "d / length(d)", "d", "direction_not_normalised"},
      {"build_bvh", "median", "if (last - first <= max_leaf)", "if (last - first <= max_leaf + 1)",
       "leaf_one_too_large"},
      {"hit_bvh", "iterative", "best = Hit{hit->t, hit->n, bvh.order[i]};",
       "best = Hit{hit->t, hit->n, i};", "position_for_primitive"},
      {"diffuse_bsdf", "uniform", "albedo / kPi", "albedo", "f_without_pi"},
      {"direct_hemisphere", "written_out", "sum / samples", "sum", "average_thrown_away"},
      {"direct_hemisphere", "written_out", "2 * point.albedo", "point.albedo", "half_of_f"},
      {"trace_path", "recursion", "sample.pdf / chance", "sample.pdf", "not_divided"},
      {"adaptive_pixel", "sum_of_squares", "1.96 * std::sqrt", "std::sqrt", "without_1_96"},
  };
  return all;
}

}  // namespace grader::self_check
