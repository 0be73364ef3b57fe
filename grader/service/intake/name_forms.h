#pragma once

#include "grader/service/intake/owner.h"

#include <limits>
#include <optional>
#include <string>

// The form that each platform gives to the names of the files in its exports.

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

// Moodle (mod/assign/classes/downloader.php): NAME_NUMBER_assignsubmission_file[_FILE]. Moodle
// writes a blank for `_` in a name. The number is the participant's, or that of a group; learners
// without a group have none.
Found moodle(const std::string& name);

// D2L: "12-34 - Ada Lovelace - Jan 15, 2027 1005 PM[ - FILE]".
Found d2l(const std::string& name);

// Blackboard: ASSIGNMENT_USER_attempt_2027-01-15-22-05-00_FILE, or .txt for what was typed. Both
// names may contain `_`. The label's name is both.
Found blackboard(const std::string& name);

// Autolab: ada@school.edu_3_FILE, with the number of the attempt.
Found autolab(const std::string& name);

// The value of digits as in Label::order.
double number(const std::string& digits);

}  // namespace grader::intake
