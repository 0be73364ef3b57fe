#pragma once

#include "pt/math/vec3.h"

#include <string>
#include <vector>

// The two random numbers of one sample: whether one of them follows from the other. A sampler that
// makes both of one number, for example xi and the later digits of xi, has right means of all
// smooth functions. Its samples lie on a few lines, where they should fill a square.

namespace grader::check {

// The results of two random numbers, both on a scale from 0 to 1: the place of a point on two axes, or
// a height and an azimuth. Pairs may be weighted.
struct NumberPair {
  double x = 0, y = 0;
  double weight = 1;
};

// Fails the case if the pairs lie on lines x = k y + constant or y = k x + constant, as they do if k is
// between -2100 and 2100 and one of the two numbers is the fraction of k times the other. Pairs without
// weights fail on any curve y(x) or x(y) that is not much steeper. `what` names the pairs.
//
// One of the two numbers has to be uniform for every value of the other one, and the pairs have to
// be independent of each other. Then this fails less than once in a billion times.
void expect_two_numbers(const std::string& what, const std::vector<NumberPair>& pairs);

}  // namespace grader::check
