#pragma once

#include "grader/service/intake/handed_in.h"

#include <set>
#include <string>
#include <vector>

namespace grader::intake {

// The learner's ID; a group on Gradescope has those of all its members.
std::set<std::string> ids_of(const HandedIn& by);

// The submissions. Those that have one ID have a problem, and no ID: nobody's grade may go to the
// learner with another's ID.
std::vector<HandedIn> with_ids_that_differ(std::vector<HandedIn> all);

// The submissions in alphabetical order, each with a name for its reports that no other submission
// and no file for the class as a whole has. Namesakes get their IDs, or numbers.
std::vector<HandedIn> with_names_that_differ(std::vector<HandedIn> all);

}  // namespace grader::intake
