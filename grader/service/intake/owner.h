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
  std::string file;      // with the learner's name for it; empty: it is a folder
  std::string before;    // the text before that
  std::string order;     // of equal names, the largest order counts
  bool late = false;
  bool text = false;  // typed into a form, not uploaded

  // A text that is the same for all files of one learner.
  std::string key() const { return name + '\n' + id; }
};

// Reads names as Canvas, Moodle, D2L and Blackboard write them; nothing for other names. For D2L
// and Blackboard only names are supported: their platform is `none`.
std::optional<Label> read_label(const std::string& name);

// Returns whether files with these names are an export of Canvas. Other files may have names of the
// same form, but an export has one number per file and one ID per learner.
bool are_of_canvas(const std::vector<std::string>& names);

}  // namespace grader::intake
