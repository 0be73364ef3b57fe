#pragma once

#include "grader/service/intake/owner.h"

#include <limits>
#include <optional>
#include <string>

// The form that Canvas gives to the names of the files in its exports. Of all platforms it is the only one whose form needs more than a
// line of grader/name_forms.csv: a name can be read in two ways, and the numbers of the other names tell which is right.

namespace grader::intake {

// A name as a platform would read it; nothing if it has another form.
using Found = std::optional<Label>;

// The numbers of files, and of learners, that are known for certain.
struct Numbers {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  double largest_id = 0;
};

// A name may end in a number: team_7_123_900_work.zip is work.zip of team_7 with the ID 123, and
// ada_123_900_1_rays.zip is 1_rays.zip of ada. Canvas counts the files of a school, so those of one
// assignment have numbers of one size. If only one reading has such a number, and an ID like those
// of the others, that one is right; if both have, the label names the rival. Without numbers to
// compare with, that of a file is larger than an ID, as Canvas has more files than users.
Found canvas_among(const std::string& name, const Numbers& certain);
Found canvas(const std::string& name);

// The value of digits as in Label::order.
double number(const std::string& digits);

}  // namespace grader::intake
