#pragma once

#include <optional>
#include <regex>
#include <string>
#include <vector>

// Forms of names as a table: a line for each platform, so that an instructor adds one without code.

namespace grader::intake {

struct Label;

// A form such as "{name}({id})" or "{id}_{any}_{attempt}_{file}". Fields: the learner's name and ID, the attempt (digits and
// signs; the largest is the last), the learner's name for the file, and {any} for what does not matter, without `_`. The
// key is the name and the ID, so that two names with one ID are no single learner. A form without {file} is that of folders and archives.
struct NameForm {
  std::string platform;
  std::vector<std::string> fields;  // in their order in the form
  std::regex shortest, longest;     // each field as short or as long as can be, from the left
};

// Reads a CSV file with the columns `platform` and `pattern`. Throws pt::Error, with the line, for a form that names no learner or has a
// field that there is not.
std::vector<NameForm> read_name_forms(const std::string& path);

// The name as this form reads it; nothing: it has another form. Where it can be read in two ways, the label has the other as its rival.
std::optional<Label> read_by(const NameForm& form, const std::string& name);

}  // namespace grader::intake
