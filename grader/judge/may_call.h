#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace grader {

// The functions outside its own file that a task may call: other tasks and the framework, by their
// names ("pt::hit_box"). Functions that are whole in a header are the task's own once it includes
// them, and are not listed. The contract of the task says the same, in the sentence "May call:
// ...".
struct MayCall {
  std::string slug;
  std::vector<std::string> functions;  // empty: none

  bool allows(std::string_view function) const;
};

// Of a task of the course. Throws pt::Error if there is no such task.
const MayCall& may_call(std::string_view slug);

// "it may only call pt::hit_box and pt::hit_sphere", or that it calls nothing: for a person to
// read.
std::string in_words(const MayCall& task);

}  // namespace grader
