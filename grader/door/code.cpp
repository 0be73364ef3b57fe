#include "grader/door/code.h"

#include <algorithm>
#include <cctype>

namespace grader::door {

namespace {

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// The end of the comment or the quoted text that begins at `at`; `at` itself if none begins there.
std::size_t behind_words(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  if (rest.starts_with("//")) return std::min(text.find('\n', at), text.size());
  if (rest.starts_with("/*")) {
    const std::size_t close = text.find("*/", at + 2);
    return close == text.npos ? text.size() : close + 2;
  }
  const char quote = rest[0];
  // An apostrophe inside a number (1'000) begins nothing.
  const bool begins = quote == '"' || (quote == '\'' && (at == 0 || !is_of_name(text[at - 1])));
  if (!begins) return at;
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != quote && text[end] != '\n')
    end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

std::size_t behind_blanks(std::string_view code, std::size_t at) {
  while (at < code.size() && is_blank(code[at])) ++at;
  return at;
}

// The last name in the declaration of a parameter: "i" of "const Intersection *i = 0".
std::string last_name(std::string_view declaration) {
  declaration = declaration.substr(0, declaration.find('='));
  std::size_t end = declaration.size();
  while (end > 0 && !is_of_name(declaration[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_of_name(declaration[begin - 1])) --begin;
  return std::string(declaration.substr(begin, end - begin));
}

// The names between two round brackets.
std::vector<std::string> names_in(std::string_view list) {
  std::vector<std::string> names;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= list.size(); ++at) {
    const char c = at < list.size() ? list[at] : ',';
    if (c == '<' || c == '(') ++depth;
    if (c == '>' || c == ')') --depth;
    if (c != ',' || (depth > 0 && at < list.size())) continue;
    const std::string name = last_name(list.substr(begin, at - begin));
    if (!name.empty()) names.push_back(name);
    begin = at + 1;
  }
  return names;
}

}  // namespace

std::string only_code(std::string_view text) {
  std::string code(text);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = behind_words(text, at);
    if (end == at) {
      ++at;
      continue;
    }
    for (; at < end; ++at) {
      if (text[at] != '\n') code[at] = ' ';
    }
  }
  return code;
}

std::size_t find_word(std::string_view code, std::string_view name, std::size_t from) {
  for (std::size_t at = code.find(name, from); at != code.npos; at = code.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || !is_of_name(code[at - 1]);
    if (begins && (end == code.size() || !is_of_name(code[end]))) return at;
  }
  return code.npos;
}

std::size_t behind_brackets(std::string_view code, std::size_t open) {
  const char begin = code[open], end = begin == '(' ? ')' : '}';
  int depth = 0;
  for (std::size_t at = open; at < code.size(); ++at) {
    if (code[at] == begin) ++depth;
    if (code[at] == end && --depth == 0) return at + 1;
  }
  return code.size();
}

std::vector<Definition> definitions_of(std::string_view code, std::string_view function) {
  std::vector<Definition> found;
  for (std::size_t at = find_word(code, function); at != code.npos;
       at = find_word(code, function, at + 1)) {
    const std::size_t open = behind_blanks(code, at + function.size());
    if (open >= code.size() || code[open] != '(') continue;
    const std::size_t close = behind_brackets(code, open);
    // Between them may be const, or the members that a constructor begins with.
    const std::size_t body = code.find_first_of("{;", close);
    if (body == code.npos || code[body] == ';') continue;
    const std::size_t end = behind_brackets(code, body);
    found.push_back({at, end, names_in(code.substr(open + 1, close - open - 2)),
                     std::string(code.substr(body, end - body))});
  }
  return found;
}

}  // namespace grader::door
