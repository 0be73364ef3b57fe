#include "grader/service/intake/name_forms.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace grader::intake {

namespace {

constexpr std::size_t kMaxDigits = 20;
constexpr double kApart = 20;  // IDs of one school have numbers of one size, to this factor
constexpr std::size_t kMaxDigitsOfFile = 12;  // Canvas: users of another school have more

// The digits at a place of a text; empty if there are none, or too many for a number.
std::string digits_at(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(std::min(at, text.size()));
  const std::size_t end = std::min(rest.find_first_not_of("0123456789"), rest.size());
  return end > kMaxDigits ? "" : std::string(rest.substr(0, end));
}

// Numbers of any length as texts that compare like the numbers.
std::string padded(const std::string& digits) {
  return std::string(kMaxDigits - std::min(kMaxDigits, digits.size()), '0') + digits;
}

// Canvas (lib/content_zipper.rb): NAME_[LATE_]ID_NUMBER_FILE, where the first `_` after the name is
// at `at`; or NAME_[LATE_]ID_text.html for text that was typed.
Found canvas_at(const std::string& name, std::size_t at) {
  Label label;
  label.platform = Platform::canvas;
  label.name = name.substr(0, at++);
  label.late = name.compare(at, 5, "LATE_") == 0;
  if (label.late) at += 5;
  label.id = digits_at(name, at);
  at += label.id.size() + 1;
  if (label.name.empty() || label.id.empty() || at >= name.size() || name[at - 1] != '_') return {};
  label.key = label.name + '\n' + label.id;
  label.file = name.substr(at);
  label.text = label.file == "text.html" || label.file == "link.html";
  if (label.text) return label;
  const std::string number = digits_at(name, at);
  at += number.size() + 1;
  if (number.empty() || number.size() > kMaxDigitsOfFile || at >= name.size() ||
      name[at - 1] != '_')
    return {};
  label.order = padded(number);
  label.file = name.substr(at);
  return label;
}

// With anonymous grading: [LATE_]anon_aB3xz_[LATE_]NUMBER_FILE.
Found anonymous(const std::string& name) {
  constexpr std::size_t kSize = 10;
  const std::size_t begin = name.starts_with("LATE_") ? 5 : 0;
  const std::string id = name.substr(begin, kSize);
  const bool is_id =
      id.size() == kSize && id.starts_with("anon_") &&
      std::all_of(id.begin() + 5, id.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
  // Without a name and an ID, the rest is as usual.
  const std::string rest = is_id ? name.substr(begin + kSize) : "";
  const bool late = rest.starts_with("_LATE_");
  Found label =
      rest.starts_with("_") ? canvas_at("anon_0" + rest.substr(late ? 5 : 0), 4) : Found();
  if (!label) return label;
  label->name = label->id = label->key = id;
  label->late = late || begin > 0;
  return label;
}

struct Words {
  std::vector<std::string> numbers, words;
};

Words words_of(const std::string& text) {
  Words all;
  for (std::size_t i = 0; i < text.size();) {
    const auto is = [&](unsigned char c) {
      return std::isdigit(c) != 0 ? 1 : std::isalpha(c) != 0 || c >= 0x80 ? 2 : 0;
    };
    const int kind = is(static_cast<unsigned char>(text[i]));
    std::string word;
    for (; i < text.size() && is(static_cast<unsigned char>(text[i])) == kind; ++i) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
    }
    if (kind == 1) all.numbers.push_back(word);
    if (kind == 2) all.words.push_back(word);
  }
  return all;
}

// A date of D2L, in the form that the course has chosen, without its colon: "Jan 15, 2027 1005 PM",
// "15 January, 2027 2205", "2027-01-15 22 05". `order` compares like the time; it is empty if the
// month is in another language.
struct Date {
  bool is_date = false;
  std::string order;
};

Date date_of(const std::string& text) {
  Words all = words_of(text);
  std::vector<std::string>& numbers = all.numbers;
  const auto year = std::ranges::find_if(numbers, [](const std::string& number) {
    return number.size() == 4 && (number.starts_with("19") || number.starts_with("20"));
  });
  if (year == numbers.end() || numbers.size() < 3 || numbers.size() > 5) return {};
  // The beginnings of the months' names in English, and where they differ in French, German and Spanish.
  constexpr std::array<std::pair<const char*, int>, 25> kMonths{
      {{"jan", 1},  {"feb", 2},  {"mar", 3},  {"apr", 4},  {"may", 5},  {"jun", 6}, {"jul", 7},
       {"aug", 8},  {"sep", 9},  {"oct", 10}, {"nov", 11}, {"dec", 12}, {"fév", 2}, {"avr", 4},
       {"mai", 5},  {"juin", 6}, {"juil", 7}, {"aoû", 8},  {"déc", 12}, {"mär", 3}, {"okt", 10},
       {"dez", 12}, {"ene", 1},  {"abr", 4},  {"ago", 8}}};
  const std::string first_number = *year;
  const bool year_first = year == numbers.begin();
  numbers.erase(year);
  int month = 0;
  for (const std::string& word : all.words) {
    for (const auto& [beginning, number] : kMonths) {
      if (word.starts_with(beginning)) month = number;
    }
  }
  // Behind a month in another language there are three numbers at most: 15, 22, 05.
  const bool has_month = numbers.size() > 3 || numbers.back().size() > 2;
  if (month == 0 && has_month && numbers[0].size() <= 2 && numbers[1].size() <= 2) {
    // Where the year is not the first, the day may be.
    if (year_first) month = std::stoi(numbers[0]);
    numbers.erase(numbers.begin());
  }
  if (numbers[0].size() > 2) return {};
  // The rest is the time: 1005, or 10 and 05.
  std::string time;
  for (std::size_t i = 1; i < numbers.size(); ++i) time += numbers[i];
  if (time.size() < 3 || time.size() > 4) return {};
  if (month == 0) return {true, ""};
  int hour = std::stoi(time.substr(0, time.size() - 2));
  std::string half;  // "pm", also for p.m.
  for (const std::string& word : all.words) half = half.size() == 1 ? half + word : word;
  if (half == "am" || half == "pm") hour = hour % 12 + (half == "pm" ? 12 : 0);
  return {true, fmt::format("{}{:02}{:0>2}{:02}{}", first_number, month, numbers[0], hour,
                            time.substr(time.size() - 2))};
}

// "2027-01-15 22:05" of the digits 202701152205, whatever stands between them; empty if they are others.
std::string time_of(const std::string& text) {
  std::string digits = text;
  std::erase_if(digits, [](unsigned char c) { return std::isdigit(c) == 0; });
  if (digits.size() < 12) return "";
  return fmt::format("{}-{}-{} {}:{}", digits.substr(0, 4), digits.substr(4, 2),
                     digits.substr(6, 2), digits.substr(8, 2), digits.substr(10, 2));
}

bool is_blackboards_date(std::string_view text) {
  constexpr std::string_view kForm = "0000-00-00-00-00-00";
  return text.size() == kForm.size() &&
         std::equal(text.begin(), text.end(), kForm.begin(), [](char c, char form) {
           return form == '0' ? std::isdigit(static_cast<unsigned char>(c)) != 0 : c == form;
         });
}

}  // namespace

double number(const std::string& digits) { return std::stod(digits); }

Found canvas_among(const std::string& name, const Numbers& certain) {
  const auto is_of_a_file = [&](const Label& label) {
    const double value = number(label.order);
    return value >= certain.least / 2 && value <= certain.largest * 2;
  };
  if (Found label = anonymous(name)) return label;
  for (std::size_t at = name.find('_'); at != name.npos; at = name.find('_', at + 1)) {
    const Found first = canvas_at(name, at);
    if (!first) continue;
    const Found second = first->late ? Found() : canvas_at(name, at + 1 + first->id.size());
    if (!second) return first;
    const bool may_be_first = first->text || is_of_a_file(*first);
    const bool is_id = number(second->id) <= kApart * certain.largest_id;
    const bool may_be_second = second->text || (is_of_a_file(*second) && is_id);
    const bool is_second = may_be_first == may_be_second
                               ? !may_be_first && number(second->order) > number(second->id)
                               : may_be_second;
    Found label = is_second ? second : first;
    label->certain = false;
    if (may_be_first && may_be_second && !second->text) {
      label->rival_key = second->key;
      label->rival_name = second->name;
      label->rival_id = second->id;
    }
    return label;
  }
  return {};
}

Found canvas(const std::string& name) { return canvas_among(name, {}); }

Found moodle(const std::string& name) {
  constexpr std::string_view kWords = "_assignsubmission_";
  const std::size_t at = name.find(kWords);
  if (at == name.npos) return {};
  Label label;
  label.platform = Platform::moodle;
  label.name = label.key = name.substr(0, at);
  const std::size_t last = label.name.rfind('_');
  if (last != label.name.npos && last + 1 < at) {
    label.id = digits_at(label.name, last + 1);
    if (last + 1 + label.id.size() != at) label.id.clear();
    if (!label.id.empty()) label.name.resize(last);
  }
  const std::string rest = name.substr(at + kWords.size());
  for (const std::string_view type : {"file", "onlinetext"}) {
    if (!rest.starts_with(type) || (rest.size() > type.size() && rest[type.size()] != '_'))
      continue;
    label.text = type != "file";
    label.file = rest.substr(std::min(rest.size(), type.size() + 1));
    return label.name.empty() ? Found() : label;
  }
  return {};
}

Found d2l(const std::string& name) {
  constexpr std::string_view kBetween = " - ";
  const std::size_t id_end = name.find(kBetween);
  if (id_end == name.npos) return {};
  Label label;
  label.id = name.substr(0, id_end);
  const std::string user = digits_at(name, 0);
  const std::string unit = digits_at(name, user.size() + 1);
  if (user.empty() || unit.empty() || label.id != user + '-' + unit) return {};
  std::size_t begin = name.find(kBetween, id_end + kBetween.size());
  while (begin != name.npos) {
    const std::size_t at = begin + kBetween.size();
    const std::size_t end = std::min(name.find(kBetween, at), name.size());
    label.dated = name.substr(at, end - at);
    const Date date = date_of(label.dated);
    if (date.is_date) {
      const std::size_t from = id_end + kBetween.size();
      label.name = name.substr(from, begin - from);
      label.key = label.name + '\n' + label.id;
      label.attempt = date.order;
      label.handed_in = time_of(date.order);
      label.file = name.substr(std::min(name.size(), end + kBetween.size()));
      return label;
    }
    begin = end == name.size() ? name.npos : end;
  }
  return {};
}

Found blackboard(const std::string& name) {
  constexpr std::string_view kWords = "_attempt_";
  constexpr std::size_t kDate = 19;
  std::size_t at = name.find(kWords);
  while (at != name.npos &&
         !is_blackboards_date(std::string_view(name).substr(at + kWords.size(), kDate)))
    at = name.find(kWords, at + 1);
  if (at == name.npos) return {};
  Label label;
  label.name = label.key = name.substr(0, at);
  label.attempt = name.substr(at + kWords.size(), kDate);
  label.handed_in = time_of(label.attempt);
  const std::string rest = name.substr(at + kWords.size() + kDate);
  label.text = rest == ".txt";
  if (!label.text && (rest.size() < 2 || rest[0] != '_')) return {};
  label.file = label.text ? "attempt.txt" : rest.substr(1);
  return label.name.find('_') == label.name.npos ? Found() : label;
}

Found autolab(const std::string& name) {
  const std::size_t sign = name.find('@');
  if (sign == name.npos || sign == 0) return {};
  const std::size_t end = name.find('_', sign);
  if (end == name.npos || name.substr(sign, end - sign).find('.') == name.npos) return {};
  Label label;
  label.name = label.id = label.key = name.substr(0, end);
  const std::string number = digits_at(name, end + 1);
  const std::size_t at = end + 1 + number.size() + 1;
  if (number.empty() || at >= name.size() || name[at - 1] != '_' ||
      label.name.find(' ') != name.npos)
    return {};
  label.attempt = padded(number);
  label.file = name.substr(at);
  return label;
}

}  // namespace grader::intake
