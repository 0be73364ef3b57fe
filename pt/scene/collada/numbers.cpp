#include "pt/scene/collada/numbers.h"

#include "pt/number.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <tinyxml2.h>

namespace pt {

namespace {

// A plus sign may stand in front; in some files the decimal point is a comma.
template <class Number>
std::optional<Number> read_word(std::string word, bool has_commas) {
  if (has_commas) std::replace(word.begin(), word.end(), ',', '.');
  const auto number = number_in<Number>(word.starts_with('+') ? word.substr(1) : word);
  return number && std::isfinite(double(*number)) ? number : std::nullopt;
}

// Appends the numbers of a text to the list.
template <class Number>
void append_words(const Document& document, const XMLElement& element, const char* kind,
                  std::vector<Number>& numbers, std::string_view text) {
  constexpr const char* kSpace = " \t\r\n";
  std::size_t at = text.find_first_not_of(kSpace);
  while (at != text.npos) {
    const std::string_view word = text.substr(at, text.find_first_of(kSpace, at) - at);
    const auto number = read_word<Number>(std::string(word), document.has_decimal_commas());
    if (!number) {
      document.fail(element,
                    quoted(word) + " in " + tag(element) + " is not " + kind + "; write one");
    }
    numbers.push_back(*number);
    at = text.find_first_not_of(kSpace, at + word.size());
  }
}

// An element holds text and comments, which may stand between numbers.
template <class Number>
std::vector<Number> read_list(const Document& document, const XMLElement& element,
                              const char* kind) {
  std::vector<Number> numbers;
  for (const tinyxml2::XMLNode* part = element.FirstChild(); part != nullptr;
       part = part->NextSibling()) {
    if (part->ToComment() != nullptr) continue;
    if (part->ToText() == nullptr) {
      document.fail(element, tag(element) + " holds more than numbers; leave only these");
    }
    append_words(document, element, kind, numbers, part->Value());
  }
  return numbers;
}

}  // namespace

std::vector<double> read_numbers(const Document& document, const XMLElement& element) {
  return read_list<double>(document, element, "a finite number");
}

std::vector<double> read_numbers(const Document& document, const XMLElement& element,
                                 std::size_t count) {
  std::vector<double> numbers = read_numbers(document, element);
  if (numbers.size() != count) {
    document.fail(element, tag(element) + " holds " + std::to_string(numbers.size()) +
                               " numbers; write " + std::to_string(count));
  }
  return numbers;
}

std::vector<int> read_integers(const Document& document, const XMLElement& element) {
  return read_list<int>(document, element, "an integer");
}

double read_number(const Document& document, const XMLElement& element) {
  return read_numbers(document, element, 1)[0];
}

std::optional<double> child_number(const Document& document, const XMLElement& parent,
                                   const char* name) {
  const XMLElement* element = parent.FirstChildElement(name);
  if (element == nullptr) return std::nullopt;
  return read_number(document, *element);
}

Rgb read_color(const Document& document, const XMLElement& element) {
  const std::vector<double> c = read_numbers(document, element);
  if (c.size() != 3 && c.size() != 4) {
    document.fail(element, tag(element) + " holds " + std::to_string(c.size()) +
                               " numbers; write red, green and blue");
  }
  if (!(c[0] >= 0 && c[1] >= 0 && c[2] >= 0)) {
    document.fail(element, tag(element) + " is negative; write numbers from 0 up");
  }
  return {c[0], c[1], c[2]};
}

std::optional<std::size_t> read_count(const Document& document, const XMLElement& element,
                                      const char* name) {
  if (element.Attribute(name) == nullptr) return std::nullopt;
  const std::string_view digits = attribute(&element, name);
  const auto value = number_in<unsigned int>(digits);
  if (!value) {
    document.fail(element, std::string(name) + "=" + quoted(digits) + " of " + tag(element) +
                               " is not a count; write an integer from 0 up");
  }
  return *value;
}

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string shown(Rgb c) { return shown(c.r) + " " + shown(c.g) + " " + shown(c.b); }

}  // namespace pt
