#pragma once

#include <string>
#include <vector>

namespace grader::self_check {

// A known mistake in other words: a right variant with one text replaced.
struct Variation {
  std::string task, right, from, to;
  std::string mistake;  // the wrong solution that makes the same mistake
};

const std::vector<Variation>& naming_variations();

}  // namespace grader::self_check
