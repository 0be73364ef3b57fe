#pragma once

#include "grader/service/intake/handed_in.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

// Tables that an instructor writes about the learners of a class: the roster, and points by hand.

namespace grader::classes {

// A row: who is meant, and the cells that have text, by column.
struct PeopleRow {
  int line = 0;
  std::string id, name;  // one of them may be empty
  std::map<std::string, std::string> cells;
};

// The name of the row, else its ID, to be printed: a long one is cut off.
std::string who(const PeopleRow& row);

// Reads a CSV file whose first line names the columns, in upper or lower case: `id` or `name`, and
// `others`. Columns with other names are left out. Throws pt::Error, with the line, for another table, and
// for a row that names nobody, or somebody who has a row already.
std::vector<PeopleRow> read_people(const std::string& path, const std::vector<std::string>& others);

// For each row, the place of its learner in `everybody`; nothing: there is none. An ID decides before a name,
// the whole name before one that differs in case or accents, and an ID that differs is
// another learner's. Members of a group share its submission. Throws pt::Error, with the line, if a row may mean two
// submissions, or if two rows mean one.
std::vector<std::optional<std::size_t>> find_people(const std::vector<PeopleRow>& rows,
                                                    const std::vector<intake::HandedIn>& everybody,
                                                    const std::string& path);

}  // namespace grader::classes
