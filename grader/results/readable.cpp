#include "grader/results/readable.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <utility>

#include <fmt/format.h>

namespace grader::results {

namespace {

constexpr int kDigits = 6, kAllDigits = 17;
constexpr std::size_t kMaxLines = 12, kShownLines = 10, kMaxLeftOut = 400;

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// The end of the number that starts at `at`, without a sign; `at` if there is none.
std::size_t end_of_number(const std::string& text, std::size_t at) {
  const auto digits = [&](std::size_t i) {
    while (i < text.size() && is_digit(text[i])) ++i;
    return i;
  };
  if (at > 0 && (in_word(text[at - 1]) || text[at - 1] == '.')) return at;
  std::size_t end = digits(at);
  if (end == at) return at;
  if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1])) end = digits(end + 1);
  if (end < text.size() && text[end] == 'e') {
    std::size_t power = end + 1;
    if (power < text.size() && (text[power] == '-' || text[power] == '+')) ++power;
    if (digits(power) > power) end = digits(power);
  }
  return end < text.size() && in_word(text[end]) ? at : end;
}

// The text with each number that is not whole replaced.
std::string replaced(const std::string& text,
                     const std::function<std::string(const std::string&)>& replace) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = end_of_number(text, i);
    if (end == i) {
      out += text[i++];
      continue;
    }
    const std::string number = text.substr(i, end - i);
    out += number.find_first_of(".e") == std::string::npos ? number : replace(number);
    i = end;
  }
  return out;
}

int digits_of(const std::string& number) {
  const std::string mantissa = number.substr(0, number.find('e'));
  int digits = 0;
  bool started = false;
  for (const char c : mantissa) {
    started = started || (is_digit(c) && c != '0');
    digits += started && is_digit(c) ? 1 : 0;
  }
  return digits;
}

std::string rounded(const std::string& number, int digits) {
  if (digits_of(number) <= digits) return number;
  const double value = std::strtod(number.c_str(), nullptr);
  // This avoids 1.23457e+06 for 1234567.8.
  const int whole = value >= 1 && value < 1e15 ? static_cast<int>(std::log10(value)) + 1 : 0;
  return fmt::format("{:.{}g}", value, std::max(digits, whole));
}

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = end_of_number(text, i);
    if (end > i) {
      const bool negative = i > 0 && text[i - 1] == '-';
      numbers.push_back((negative ? -1 : 1) *
                        std::strtod(text.substr(i, end - i).c_str(), nullptr));
    }
    i = std::max(end, i + 1);
  }
  return numbers;
}

std::string with_digits(const std::string& text, int digits) {
  return replaced(text, [&](const std::string& number) { return rounded(number, digits); });
}

// Returns whether differences of numbers at the same places stay the same, to a tenth.
bool shows_differences(const std::vector<double>& a, const std::vector<double>& b,
                       const std::vector<double>& short_a, const std::vector<double>& short_b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const double exact = a[i] - b[i], shown = short_a[i] - short_b[i];
    if (!(std::abs(shown - exact) <= 0.1 * std::abs(exact))) return false;
  }
  return true;
}

// The number of digits that shows how `got` differs from `expected`.
int digits_for(const std::string& got, const std::string& expected) {
  const std::vector<double> a = numbers_in(got), b = numbers_in(expected);
  for (int digits = kDigits; digits < kAllDigits; ++digits) {
    if (shows_differences(a, b, numbers_in(with_digits(got, digits)),
                          numbers_in(with_digits(expected, digits)))) {
      return digits;
    }
  }
  return kAllDigits;
}

}  // namespace

std::string with_few_digits(const std::string& text) {
  return replaced(text, [](const std::string& number) {
    const std::string few = rounded(number, kDigits);
    constexpr int kSimple = 3;
    return digits_of(few) <= kSimple && digits_of(number) > kDigits && few != number ? number : few;
  });
}

Readable readable(Failure failure) {
  Readable shown;
  std::vector<std::string>& input = failure.input;
  if (input.size() > kMaxLines) {
    shown.lines_left_out = input.size() - kShownLines;
    const auto first = input.begin() + kShownLines;
    shown.left_out.assign(
        first, first + static_cast<std::ptrdiff_t>(std::min(shown.lines_left_out, kMaxLeftOut)));
    input.erase(first, input.end());
  }
  const std::size_t untold = shown.lines_left_out - shown.left_out.size();
  for (auto* lines : {&input, &shown.left_out}) {
    for (std::string& line : *lines) line = with_few_digits(line);
  }
  if (untold > 0) shown.left_out.push_back(more_lines(untold));
  const int digits = digits_for(failure.got, failure.expected);
  failure.got = with_digits(failure.got, digits);
  failure.expected = with_digits(failure.expected, digits);
  shown.failure = std::move(failure);
  return shown;
}

std::string more_lines(std::size_t count) {
  return fmt::format("and {} more lines; --json writes them all", count);
}

}  // namespace grader::results
