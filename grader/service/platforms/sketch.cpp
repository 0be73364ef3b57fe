#include "grader/service/platforms/sketch.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <set>
#include <string_view>

namespace grader::platforms {

namespace {

constexpr std::size_t kTokens = 12, kWindow = 8;
constexpr std::size_t kMaxSource = std::size_t{256} << 10;  // bytes

struct Token {
  std::string_view text;
  std::size_t line = 0;
};

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || (c & 0x80) != 0;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Words of the language. All other names are equal, as whoever copies can change them.
const std::set<std::string_view>& words() {
  static const std::set<std::string_view> all{
      "auto",      "bool",     "break",   "case",     "char",     "class", "const",
      "constexpr", "continue", "default", "do",       "double",   "else",  "enum",
      "false",     "float",    "for",     "if",       "inline",   "int",   "long",
      "namespace", "new",      "nullptr", "operator", "return",   "short", "signed",
      "sizeof",    "static",   "struct",  "switch",   "template", "this",  "throw",
      "true",      "typename", "union",   "unsigned", "using",    "void",  "while"};
  return all;
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::vector<Token> run() {
    std::vector<Token> tokens;
    while (at_ < text_.size()) {
      const std::size_t begin = at_;
      const char c = text_[at_];
      if (starts("//") || c == '#') {
        skip_line();
      } else if (starts("/*")) {
        skip_to("*/", 2);
      } else if (c == '"' || c == '\'') {
        skip_quoted(c);
        add(tokens, "\"", begin);
      } else if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
        skip_number();
        add(tokens, "0", begin);
      } else if (is_letter(c)) {
        while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
        const std::string_view word = text_.substr(begin, at_ - begin);
        add(tokens, words().contains(word) ? word : "name", begin);
      } else {
        ++at_;
        const bool is_sign = std::isspace(static_cast<unsigned char>(c)) == 0 && c != '\\';
        if (is_sign) add(tokens, text_.substr(begin, 1), begin);
      }
    }
    return tokens;
  }

 private:
  bool starts(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

  void add(std::vector<Token>& tokens, std::string_view text, std::size_t begin) {
    line_ += static_cast<std::size_t>(
        std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                   text_.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
    counted_ = begin;
    tokens.push_back({text, line_});
  }

  // A line that ends in a backslash goes on.
  void skip_line() {
    while (at_ < text_.size() && text_[at_] != '\n') at_ += text_[at_] == '\\' ? 2 : 1;
    at_ = std::min(at_, text_.size());
  }

  void skip_to(std::string_view end, std::size_t from) {
    const std::size_t found = text_.find(end, at_ + from);
    at_ = found == text_.npos ? text_.size() : found + end.size();
  }

  void skip_quoted(char quote) {
    for (++at_; at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    at_ = std::min(at_ + 1, text_.size());
  }

  void skip_number() {
    const auto is_exponent = [](char c) { return c == 'e' || c == 'E'; };
    for (++at_; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      const bool is_sign = (c == '+' || c == '-') && is_exponent(text_[at_ - 1]);
      if (!is_letter(c) && c != '.' && c != '\'' && !is_sign) return;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0, counted_ = 0, line_ = 1;
};

// FNV-1a, of 64 bits: the same on every machine.
std::uint64_t hash_of(const Token* tokens) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (std::size_t i = 0; i < kTokens; ++i) {
    for (const char c : tokens[i].text)
      hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    hash = (hash ^ 0xff) * 0x100000001b3U;
  }
  return hash;
}

}  // namespace

std::vector<Print> sketch_of(const std::string& source) {
  const std::vector<Token> tokens = Reader(std::string_view(source).substr(0, kMaxSource)).run();
  std::vector<Print> all, kept;
  for (std::size_t i = 0; i + kTokens <= tokens.size(); ++i)
    all.push_back({hash_of(&tokens[i]), tokens[i].line, tokens[i + kTokens - 1].line});
  const std::size_t window = std::min(kWindow, all.size());
  std::size_t last = all.size();
  for (std::size_t i = 0; window > 0 && i + window <= all.size(); ++i) {
    // Of equal ones that which is kept already, so that a long row of equal tokens has few prints.
    std::size_t least = i;
    for (std::size_t k = i; k < i + window; ++k) {
      if (all[k].hash <= all[least].hash) least = k;
    }
    if (last < all.size() && last >= i && all[last].hash == all[least].hash) continue;
    kept.push_back(all[least]);
    last = least;
  }
  return kept;
}

}  // namespace grader::platforms
