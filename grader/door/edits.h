#pragma once

#include "grader/door/clone.h"

#include <string>

namespace grader::door {

// The text of a learner's file as it is compiled here. Lines keep their numbers. Two things are
// different: what is private is public, and `class PathTracer` has a base class (around/before.txt) in
// which the functions that estimate light are virtual. So each of them can be tested with the
// judge's functions around it. A picture has one pixel. The windows and threads of 2019 are left out.
std::string edited(const std::string& text, const std::string& path, Generation generation);

}  // namespace grader::door
