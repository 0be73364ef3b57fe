#include "grader/mistakes/answers.h"

#include "pt/error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::mistakes {

using nlohmann::json;

namespace {

// Keeps only the digits that a comparison needs. A number that is not finite becomes a text.
json rounded(double value, int digits) {
  if (!std::isfinite(value)) return fmt::format("{}", value);
  const double shorter = std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
  if (shorter == std::floor(shorter) && std::abs(shorter) < 1e9) {
    return static_cast<long long>(shorter);
  }
  return shorter;
}

json rounded(const std::vector<double>& values, int digits) {
  json list = json::array();
  for (const double value : values) list.push_back(rounded(value, digits));
  return list;
}

std::vector<double> read_numbers(const json& from) {
  std::vector<double> values;
  for (const json& each : from) {
    values.push_back(each.is_string() ? std::strtod(each.get<std::string>().c_str(), nullptr)
                                      : each.get<double>());
  }
  return values;
}

bool same(const Answer& a, const Answer& b) {
  const auto equal = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return a.ended == b.ended && std::ranges::equal(a.values, b.values, equal);
}

}  // namespace

bool always_the_same(const Answers& answers) {
  std::map<std::size_t, const Answer*> first;  // by the number of values
  return std::ranges::all_of(answers, [&](const Answer& answer) {
    return same(*first.try_emplace(answer.values.size(), &answer).first->second, answer);
  });
}

bool shows_nothing(const Answers& answers) {
  constexpr std::size_t kChannels = 3;
  const auto is_estimate = [](const Answer& answer) { return !answer.errors.empty(); };
  const bool estimates = std::ranges::any_of(answers, is_estimate);
  return std::ranges::all_of(answers, [&](const Answer& answer) {
    if (!answer.ended.empty()) return false;
    if (estimates && !is_estimate(answer)) return true;
    const std::size_t n =
        estimates ? std::min(answer.values.size(), kChannels) : answer.values.size();
    return std::ranges::all_of(std::span(answer.values).first(n), [](double x) { return x == 0; });
  });
}

json describe(const Answer& answer) {
  constexpr int kDigits = 8, kErrorDigits = 3;
  if (!answer.ended.empty()) return answer.ended;
  if (answer.errors.empty()) return rounded(answer.values, kDigits);
  return {{"value", rounded(answer.values, kDigits)},
          {"error", rounded(answer.errors, kErrorDigits)}};
}

Answer read_answer(const json& from) {
  if (from.is_string()) return {from.get<std::string>(), {}, {}};
  if (from.is_array()) return {"", read_numbers(from), {}};
  return {"", read_numbers(from.at("value")), read_numbers(from.at("error"))};
}

std::string to_json(const Answers& answers) {
  json all = json::array();
  for (const Answer& answer : answers) all.push_back(describe(answer));
  return all.dump();
}

Answers answers_from_json(const std::string& text) {
  try {
    Answers answers;
    for (const auto& each : json::parse(text)) answers.push_back(read_answer(each));
    return answers;
  } catch (const json::exception& error) {
    throw pt::Error(std::string("these are not the answers of a battery:  ") + error.what());
  }
}

}  // namespace grader::mistakes
