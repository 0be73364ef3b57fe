#include "grader/check/scenes/closed_forms.h"

#include <cmath>

namespace grader::check {

using pt::Rgb;
using pt::Vec3;

namespace {

// The part of the polygon with dot(q - p, n) >= 0 (Sutherland and Hodgman 1974), relative to p.
std::vector<Vec3> above_horizon(const std::vector<Vec3>& corners, Vec3 p, Vec3 n) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = corners[i] - p;
    const Vec3 b = corners[(i + 1) % corners.size()] - p;
    const double height_a = dot(a, n), height_b = dot(b, n);
    if (height_a >= 0) kept.push_back(a);
    if ((height_a < 0) != (height_b < 0)) {
      kept.push_back(a + height_a / (height_a - height_b) * (b - a));
    }
  }
  return kept;
}

}  // namespace

double cosine_of_polygon(const std::vector<Vec3>& corners, Vec3 p, Vec3 n) {
  const std::vector<Vec3> seen = above_horizon(corners, p, n);
  double sum = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Vec3 a = seen[i];
    const Vec3 b = seen[(i + 1) % seen.size()];
    const Vec3 across = cross(a, b);
    const double sine = length(across);
    if (sine > 0) sum += std::atan2(sine, dot(a, b)) * dot(across, n) / sine;
  }
  return std::abs(sum) / 2;
}

double cosine_of_ball(Vec3 center, double radius, Vec3 p, Vec3 n) {
  const Vec3 to_center = center - p;
  if (dot(to_center, n) < 0) return 0;
  const double squared = length_squared(to_center);
  return pt::kPi * radius * radius / squared * dot(to_center, n) / std::sqrt(squared);
}

double cosine_of_half_space(Vec3 up, Vec3 n) { return pt::kPi * (1 + dot(up, n)) / 2; }

double solid_angle(Vec3 p0, Vec3 p1, Vec3 p2, Vec3 p) {
  const Vec3 a = normalize(p0 - p), b = normalize(p1 - p), c = normalize(p2 - p);
  return 2 * std::atan2(std::abs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

Rgb power_sum(Rgb a, int from, int to) {
  Rgb power = pt::gray(1), sum;
  for (int k = 0; k <= to; ++k) {
    if (k >= from) sum += power;
    power *= a;
  }
  return sum;
}

double chi_square_limit(int degrees_of_freedom) {
  const double k = degrees_of_freedom;
  const double spread = 2 / (9 * k);
  return k * std::pow(1 - spread + 6 * std::sqrt(spread), 3);
}

}  // namespace grader::check
