#pragma once

#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

#include <vector>

// Formulas that give light exactly. They are the oracles of the tasks that estimate light.

namespace grader::check {

// The irradiance at p, where the normal is n, from a flat convex polygon of radiance 1; in [0, pi].
// It is the cosine, summed over all directions from p to the part of the polygon above the horizon,
// by Lambert's formula (Lambert 1760, Photometria). p must not be in the polygon's plane.
double cosine_of_polygon(const std::vector<pt::Vec3>& corners, pt::Vec3 p, pt::Vec3 n);

// The same for a ball that is entirely above the horizon: pi (R / D)^2 cos. It is 0 if the ball is
// entirely below.
double cosine_of_ball(pt::Vec3 center, double radius, pt::Vec3 p, pt::Vec3 n);

// The same for the half of all directions with dot(direction, up) > 0.
double cosine_of_half_space(pt::Vec3 up, pt::Vec3 n);

// The solid angle of a triangle seen from p (Van Oosterom and Strackee 1983).
double solid_angle(pt::Vec3 p0, pt::Vec3 p1, pt::Vec3 p2, pt::Vec3 p);

// a^from + ... + a^to, channel by channel.
pt::Rgb power_sum(pt::Rgb a, int from, int to);

// Returns the limit of a chi-square statistic with so many degrees of freedom. By chance, the
// statistic exceeds it with a probability of about 1e-9 (Wilson and Hilferty 1931).
double chi_square_limit(int degrees_of_freedom);

}  // namespace grader::check
