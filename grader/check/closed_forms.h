#pragma once

#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

#include <vector>

// Light where a formula gives it exactly: the oracles of the tasks that estimate light.

namespace grader::check {

// The cosine at p, summed over all directions that a flat convex polygon fills above the surface
// with normal n at p: the irradiance that it gives for radiance 1, in [0, pi]. Lambert's formula
// (Lambert 1760, Photometria), for the part of the polygon above the horizon. p is not in its
// plane.
double cosine_of_polygon(const std::vector<pt::Vec3>& corners, pt::Vec3 p, pt::Vec3 n);

// The same for a ball that is wholly above the horizon: pi (R / D)^2 cos; 0 if it is wholly below.
double cosine_of_ball(pt::Vec3 center, double radius, pt::Vec3 p, pt::Vec3 n);

// The same for the half of all directions with dot(direction, up) > 0.
double cosine_of_half_space(pt::Vec3 up, pt::Vec3 n);

// The solid angle of a triangle seen from p (Van Oosterom and Strackee 1983).
double solid_angle(pt::Vec3 p0, pt::Vec3 p1, pt::Vec3 p2, pt::Vec3 p);

// a^from + ... + a^to, channel by channel.
pt::Rgb power_sum(pt::Rgb a, int from, int to);

// The value that a chi-square statistic of so many degrees of freedom exceeds by chance about 1e-9
// of the time (Wilson and Hilferty 1931).
double chi_square_limit(int degrees_of_freedom);

}  // namespace grader::check
