#pragma once

#include <string>
#include <string_view>
#include <vector>

// C++ read roughly: enough to find definitions of functions in a learner's file, whatever is in it.

namespace grader::door {

// The text with spaces in place of comments and of what is between quotation marks. Every other
// character keeps its place, and newlines stay.
std::string only_code(std::string_view text);

// The place of a name from `from` on, where it is a whole word; npos if it is not there.
std::size_t find_word(std::string_view code, std::string_view name, std::size_t from = 0);

// The place behind the bracket that closes the one at `open`, or the end of the code.
std::size_t behind_brackets(std::string_view code, std::size_t open);

// A definition `Class::name(parameters) ... { body }` of a member function.
struct Definition {
  std::size_t name = 0;                   // where "Class" begins
  std::size_t end = 0;                    // behind the body
  std::vector<std::string> parameters{};  // their names
  std::string body{};
};

// All definitions of a member function: "BBox::intersect". `code` has no comments.
std::vector<Definition> definitions_of(std::string_view code, std::string_view function);

}  // namespace grader::door
