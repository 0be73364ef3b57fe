#pragma once

// The numbers in which a right solution may compute.

namespace grader::check {

// From now on, sums and statistics in single precision are right too: for work in the skeleton of a course that has colours of floats.
void allow_single_precision();
bool is_single_precision_allowed();

}  // namespace grader::check
