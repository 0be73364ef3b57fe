#include "grader/service/intake/owner.h"

#include <algorithm>
#include <ctime>
#include <map>
#include <regex>
#include <set>

namespace grader::intake {

namespace {

// Numbers of any length as texts that compare like the numbers.
std::string padded(const std::string& digits) {
  constexpr std::size_t kDigits = 24;
  return std::string(kDigits - std::min(kDigits, digits.size()), '0') + digits;
}

// "Jan 15, 2027 1005 PM" as a text that compares like the time; empty if it is not a time.
std::string time_order(const std::string& text) {
  std::tm time{};
  const char* end = strptime(text.c_str(), "%b %d, %Y %I%M %p", &time);
  char order[32] = "";
  if (end != nullptr) std::strftime(order, sizeof order, "%Y%m%d%H%M", &time);
  return order;
}

std::optional<Label> canvas_label(const std::string& name) {
  static const std::regex named(R"((.+?)_(LATE_)?(\d{1,20})_(\d{1,20})_(.+))");
  static const std::regex anonymous(R"((LATE_)?(anon_[A-Za-z0-9]{5})_(LATE_)?(\d{1,20})_(.+))");
  static const std::regex typed(R"((.+?)_(LATE_)?(\d{1,20})_((?:text|link)\.html))");
  std::smatch found;
  Label label;
  const auto take = [&](std::size_t name_at, std::size_t id_at, bool late) {
    label.platform = Platform::canvas;
    label.name = found[name_at];
    label.id = found[id_at];
    label.late = late;
    label.file = found[found.size() - 1];
  };
  if (std::regex_match(name, found, anonymous)) {
    take(2, 2, found[1].matched || found[3].matched);
  } else if (std::regex_match(name, found, named)) {
    take(1, 3, found[2].matched);
  } else if (std::regex_match(name, found, typed)) {
    take(1, 3, found[2].matched);
    label.text = true;
  } else {
    return std::nullopt;
  }
  if (!label.text) label.order = padded(found[4]);
  return label;
}

std::optional<Label> moodle_label(const std::string& name) {
  static const std::regex moodle(R"((.+)_(\d{1,20})_assignsubmission_(file|onlinetext)_?(.*))");
  std::smatch found;
  if (!std::regex_match(name, found, moodle)) return std::nullopt;
  Label label;
  label.platform = Platform::moodle;
  label.name = found[1];
  label.id = found[2];
  label.text = found[3] == "onlinetext";
  label.file = found[4];
  return label;
}

std::optional<Label> dated_label(const std::string& name) {
  static const std::regex d2l(
      R"((\d+-\d+) - (.+?) - ([A-Z][a-z]{2,8} \d{1,2}, \d{4} \d{3,4} [AP]M)(?: - (.+))?)");
  static const std::regex blackboard(R"(.+_([^_]+)_attempt_(\d{4}(?:-\d\d){5})(?:_(.+)|\.txt))");
  std::smatch found;
  Label label;
  if (std::regex_match(name, found, d2l)) {
    label.id = found[1];
    label.name = found[2];
    label.order = time_order(found[3]);
    label.file = found[4];
  } else if (std::regex_match(name, found, blackboard)) {
    label.name = found[1];
    label.order = found[2];
    label.text = !found[3].matched;
    label.file = label.text ? "attempt.txt" : found[3].str();
  } else {
    return std::nullopt;
  }
  return label;
}

}  // namespace

std::optional<Label> read_label(const std::string& name) {
  const auto holds = [&](const char* words) { return name.find(words) != name.npos; };
  std::optional<Label> label;  // computed once: regular expressions are slow
  if (holds("_assignsubmission_")) label = moodle_label(name);
  if (!label && (holds(" - ") || holds("_attempt_"))) label = dated_label(name);
  if (!label) label = canvas_label(name);
  if (label)
    label->before = name.substr(0, name.size() - std::min(name.size(), label->file.size()));
  return label;
}

bool are_of_canvas(const std::vector<std::string>& names) {
  std::set<std::string> numbers;
  std::map<std::string, std::string> learners;
  for (const std::string& name : names) {
    const std::optional<Label> label = read_label(name);
    if (!label || label->platform != Platform::canvas) continue;
    if (!label->text && !numbers.insert(label->order).second) return false;
    if (learners.try_emplace(label->id, label->name).first->second != label->name) return false;
  }
  return !numbers.empty();
}

}  // namespace grader::intake
