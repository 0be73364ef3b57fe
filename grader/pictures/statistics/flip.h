#pragma once

#include "pt/image/image.h"

namespace grader::pictures {

// The mean of FLIP over the pixels: how much somebody sees change who flips between the two pictures as ./run render writes
// them to a PNG, from 0 to 1 (Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images"). The screen is the
// paper's: .7 m wide, with 3840 pixels, from a distance of .7 m. The pictures have one size; a pixel that is not finite is black.
double flip(const pt::Image& a, const pt::Image& b);

}  // namespace grader::pictures
