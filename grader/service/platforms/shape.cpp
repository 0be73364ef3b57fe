#include "grader/service/platforms/shape.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <vector>

namespace grader::platforms {

namespace {

using Tokens = std::vector<std::string>;

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || (c & 0x80) != 0;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_name(const std::string& token) { return is_letter(token[0]) && !is_digit(token[0]); }

// The end of a literal in quotes that begins at `at`; `raw`: as in R"x(...)x".
std::size_t end_of_quoted(const std::string& text, std::size_t at, bool raw) {
  if (raw) {
    const std::size_t open = text.find('(', at);
    if (open == text.npos) return text.size();
    const std::string close = ")" + text.substr(at + 1, open - at - 1) + "\"";
    const std::size_t end = text.find(close, open);
    return end == text.npos ? text.size() : end + close.size();
  }
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != text[at] && text[end] != '\n')
    end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

std::size_t end_of_number(const std::string& text, std::size_t at) {
  std::size_t end = at + 1;
  const auto is_exponent = [](char c) { return c == 'e' || c == 'E' || c == 'p' || c == 'P'; };
  while (end < text.size() &&
         (is_letter(text[end]) || text[end] == '.' || text[end] == '\'' ||
          ((text[end] == '+' || text[end] == '-') && is_exponent(text[end - 1]))))
    ++end;
  return end;
}

// The end of a comment that begins at `at`, or `at`.
std::size_t end_of_comment(const std::string& text, std::size_t at) {
  const bool line = text.compare(at, 2, "//") == 0, block = text.compare(at, 2, "/*") == 0;
  if (!line && !block) return at;
  const std::size_t end = text.find(line ? "\n" : "*/", at + 2);
  return end == text.npos ? text.size() : line ? end : end + 2;
}

// The tokens of C++, but for signs, which are single: `> >` is `>>`.
Tokens tokens_of(std::string text) {
  for (std::size_t at = 0; (at = text.find("\\\n", at)) != text.npos;) text.erase(at, 2);
  Tokens tokens;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    const char c = text[at];
    end = end_of_comment(text, at);
    if (end > at) continue;
    end = at + 1;
    if (std::isspace(static_cast<unsigned char>(c)) != 0) continue;
    if (is_digit(c) || (c == '.' && at + 1 < text.size() && is_digit(text[at + 1]))) {
      end = end_of_number(text, at);
    } else if (c == '"' || c == '\'') {
      end = end_of_quoted(text, at, !tokens.empty() && at > 0 && text[at - 1] == 'R');
    } else if (is_letter(c)) {
      while (end < text.size() && is_letter(text[end])) ++end;
    }
    tokens.push_back(text.substr(at, end - at));
  }
  return tokens;
}

// After these a name is used. After any other word it is declared: `double x`, `struct X`.
const std::set<std::string> kBeforeUse{
    "return", "else",    "case",     "new",       "delete",   "throw",       "goto",   "co_return",
    "sizeof", "alignof", "co_yield", "do",        "co_await", "not",         "and",    "or",
    "const",  "static",  "inline",   "constexpr", "mutable",  "volatile",    "extern", "explicit",
    "xor",    "include", "operator", "friend",    "virtual",  "thread_local"};

// Words of the language that stand after others, as in `const double`. Nobody declares them.
const std::set<std::string> kWords{
    "auto",     "bool",     "char",     "const",     "constexpr", "double", "float",    "inline",
    "int",      "long",     "noexcept", "short",     "signed",    "static", "struct",   "class",
    "unsigned", "void",     "volatile", "mutable",   "override",  "final",  "typename", "template",
    "using",    "operator", "enum",     "namespace", "default",   "if",     "for",      "while",
    "and",      "or",       "not",      "xor",       "requires",  "return", "switch",   "union"};

// A list of names or of parameters has fewer tokens. The bound keeps a hostile file from taking long.
constexpr std::size_t kMaxList = 100;

// A file declares its own names: this finds them by its tokens.
class Names {
 public:
  explicit Names(const Tokens& tokens) : tokens_(tokens) {
    for (std::size_t i = 1; i < tokens.size(); ++i) {
      if (at(i) == "[" && is_after_auto(i)) add_bindings(i);
      if (is_name(at(i)) && !kWords.contains(at(i)) && is_declared(i)) names_.insert(at(i));
    }
    add_members();
  }

  // A name after a dot belongs to a type: its own, or one of the renderer.
  bool is_own(std::size_t i) const {
    if (!is_name(at(i))) return false;
    return is_member(i) ? members_.contains(at(i)) : names_.contains(at(i));
  }

 private:
  const std::string& at(std::size_t i) const {
    static const std::string none = ";";
    return i < tokens_.size() ? tokens_[i] : none;
  }

  bool is_member(std::size_t i) const {
    if (i == 0) return false;
    return at(i - 1) == "." || (i > 1 && at(i - 1) == ">" && at(i - 2) == "-") ||
           (i > 1 && at(i - 1) == ":" && at(i - 2) == ":");
  }

  bool is_after_auto(std::size_t i) const {
    while (i > 0 && (at(i - 1) == "&" || at(i - 1) == "const")) --i;
    return i > 0 && at(i - 1) == "auto";
  }

  void add_bindings(std::size_t i) {
    for (const std::size_t end = i + kMaxList; at(i) != "]" && i < end; ++i) {
      if (is_name(at(i))) names_.insert(at(i));
    }
  }

  bool is_declared(std::size_t i) const {
    const std::string& before = at(i - 1);
    const std::string& after = at(i + 1);
    if (is_member(i)) return false;
    if (is_name(before)) return !kBeforeUse.contains(before);
    if (before == ",") return after == "=" || after == ";" || after == "{";
    const bool is_sign = before == "&" || before == "*" || before == ">";
    if (!is_sign || i < 2 ||
        (before != ">" && !is_name(at(i - 2)) && at(i - 2) != ">" && at(i - 2) != "&"))
      return false;
    return after != "(" || begins_body(i + 1);
  }

  // Returns whether a body follows the parentheses that open at i: they are a function's parameters.
  bool begins_body(std::size_t i) const {
    int depth = 0;
    const std::size_t end = i + kMaxList;
    do {
      depth += at(i) == "(" ? 1 : at(i) == ")" ? -1 : 0;
      ++i;
    } while (depth > 0 && i < end);
    return at(i) == "{" || ((at(i) == "const" || at(i) == "noexcept") && at(i + 1) == "{");
  }

  // Names that are declared directly in the body of a struct.
  void add_members() {
    std::vector<bool> is_struct;  // of the braces that are open
    bool begins_struct = false;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (at(i) == "struct" || at(i) == "class") begins_struct = true;
      if (at(i) == ";" || at(i) == "(") begins_struct = false;
      if (at(i) == "{") is_struct.push_back(begins_struct), begins_struct = false;
      if (at(i) == "}" && !is_struct.empty()) is_struct.pop_back();
      if (!is_struct.empty() && is_struct.back() && names_.contains(at(i)) && is_declared(i))
        members_.insert(at(i));
    }
  }

  const Tokens& tokens_;
  std::set<std::string> names_, members_;
};

}  // namespace

Shape shape_of(const std::string& source) {
  const Tokens tokens = tokens_of(source);
  const Names names(tokens);
  std::map<std::string, std::size_t> numbers;
  Shape shape{"", tokens.size()};
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (names.is_own(i)) {
      shape.text +=
          "name " + std::to_string(numbers.try_emplace(tokens[i], numbers.size()).first->second);
    } else {
      shape.text += tokens[i];
    }
    shape.text += '\n';
  }
  return shape;
}

}  // namespace grader::platforms
