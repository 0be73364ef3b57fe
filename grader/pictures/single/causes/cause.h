#pragma once

#include "grader/pictures/single/verdict.h"

#include <string>
#include <vector>

namespace grader::pictures {

// The one cause that explains a wrong picture; empty if none does, or several do. A cause counts only if the picture agrees with ours once
// ours have the same fault, by the test that called it wrong. `ours` are our pictures before any codec.
std::string cause_of(const SinglePicture& picture, const SingleQuestion& question,
                     const std::vector<pt::Image>& ours, const SingleVerdict& verdict);

}  // namespace grader::pictures
