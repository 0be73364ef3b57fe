#include "grader/service/intake/written_date.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace grader::intake {

namespace {

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

}  // namespace

WrittenDate written_date(const std::string& text) {
  Words all = words_of(text);
  std::vector<std::string>& numbers = all.numbers;
  const auto year = std::ranges::find_if(numbers, [](const std::string& number) {
    return number.size() == 4 && (number.starts_with("19") || number.starts_with("20"));
  });
  constexpr std::size_t kWithSeconds = 6;  // of 2027-01-15-22-05-33
  const bool has_seconds = numbers.size() == kWithSeconds && year == numbers.begin() &&
                           std::all_of(numbers.begin() + 1, numbers.end(),
                                       [](const auto& number) { return number.size() == 2; });
  if (year == numbers.end() || numbers.size() < 3 || (numbers.size() > 5 && !has_seconds))
    return {};
  const std::string seconds = has_seconds ? numbers.back() : "00";
  if (has_seconds) numbers.pop_back();
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
  if (month == 0) return {true, "", ""};
  int hour = std::stoi(time.substr(0, time.size() - 2));
  std::string half;  // "pm", also for p.m.
  for (const std::string& word : all.words) half = half.size() == 1 ? half + word : word;
  if (half == "am" || half == "pm") hour = hour % 12 + (half == "pm" ? 12 : 0);
  const std::string minute = time.substr(time.size() - 2);
  return {
      true,
      fmt::format("{}{:02}{:0>2}{:02}{}{}", first_number, month, numbers[0], hour, minute, seconds),
      fmt::format("{}-{:02}-{:0>2} {:02}:{}", first_number, month, numbers[0], hour, minute)};
}

}  // namespace grader::intake
