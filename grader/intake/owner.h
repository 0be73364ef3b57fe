#pragma once

#include <optional>
#include <string>
#include <vector>

namespace grader::intake {

enum class Platform { none, canvas, moodle, gradescope };

// The parts of the name that a platform gives to a file or folder of a learner.
struct Label {
  Platform platform = Platform::none;
  std::string name, id;  // of the learner; the ID may be empty
  std::string file;      // as the learner named it; empty: it is a folder
  std::string before;    // what stands before that
  std::string order;     // of files with equal names, the one with the largest order is used
  bool late = false;
  bool text = false;  // words typed into a form, and nothing that was uploaded

  // The same for everything of one learner.
  std::string key() const { return name + '\n' + id; }
};

// Reads names as Canvas, Moodle, D2L and Blackboard write them; nothing for other names. D2L and
// Blackboard have no more than names here: their platform is `none`.
std::optional<Label> read_label(const std::string& name);

// Returns whether files with these names are an export of Canvas. Others may have names of the same form; an export has a number
// for each file and an ID for each learner.
bool are_of_canvas(const std::vector<std::string>& names);

}  // namespace grader::intake
