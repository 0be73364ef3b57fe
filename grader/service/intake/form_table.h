#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// Forms of names as a table: a line for each platform, so that an instructor adds one without code.

namespace grader::intake {

struct Label;

// A form such as "{name}({id})" or "{id}_{any}_{attempt}[_{file}]". What stands in [ ] may be missing. The fields are in kKinds of
// form_table.cpp, and in docs/instructors/platforms.md. The key is the name and the ID, so that two names with one ID are no single learner.
struct NameForm {
  struct Part {
    std::string field, text;  // one of both is empty
  };
  using Parts = std::vector<Part>;

  std::string platform, pattern;
  std::vector<Parts> readings;  // with and without what stands in [ ]; the first that fits counts
};

// Throws pt::Error, with the reason, for a form that names no learner or has a field that there is not.
NameForm name_form(const std::string& platform, const std::string& pattern);

// Reads a CSV file with the columns `platform` and `pattern`. Throws pt::Error, with the line, for a form that cannot be used.
std::vector<NameForm> read_name_forms(const std::string& path);

// The name as this form reads it; nothing: it has another form. A form without {file} and {text} is that of folders and archives. Where
// the name can be read in two ways, the label has the other as its rival. Not so in a form with a {date}: the platform writes it before
// what a learner has chosen, so the first date is the platform's.
std::optional<Label> read_by(const NameForm& form, const std::string& name, bool is_folder);

// The text between {same} and {name}, if the form has them: all names of the platform have the same text before it. Their labels' names are {same},
// this text and {name}, until all are known.
std::string between_same_and_name(const NameForm& form);

}  // namespace grader::intake
