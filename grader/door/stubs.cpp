#include "grader/door/stubs.h"

#include "grader/door/code.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace grader::door {

namespace {

// Returns whether a word is used, other than as the last part of a qualified name.
bool mentions(std::string_view code, const std::string& word) {
  for (std::size_t at = find_word(code, word); at != code.npos;
       at = find_word(code, word, at + 1)) {
    if (at < 2 || code.substr(at - 2, 2) != "::") return true;
  }
  return false;
}

bool mentions_any(const Stub& stub, const Definition& function) {
  return std::ranges::any_of(stub.words, [&](const std::string& word) {
    const std::vector<std::string>& names = function.parameters;
    if (!word.starts_with('$')) return mentions(function.body, word);
    return !names.empty() &&
           mentions(function.body, word == "$first" ? names.front() : names.back());
  });
}

}  // namespace

bool is_unwritten(const Adapter& adapter, const std::string& code) {
  return std::ranges::any_of(adapter.stubs, [&](const Stub& stub) {
    if (stub.function.empty()) {
      return std::ranges::none_of(stub.words,
                                  [&](const std::string& word) { return mentions(code, word); });
    }
    const std::vector<Definition> all = definitions_of(code, stub.function);
    return std::ranges::any_of(all,
                               [&](const Definition& each) { return !mentions_any(stub, each); });
  });
}

}  // namespace grader::door
