#include "grader/service/intake/form_table.h"

#include "grader/base/printable.h"
#include "grader/report/read_csv.h"
#include "grader/service/intake/file_name.h"
#include "grader/service/intake/owner.h"
#include "grader/service/intake/written_date.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace grader::intake {

namespace {

constexpr std::size_t kMaxTable = std::size_t{64} << 10;  // bytes
constexpr std::size_t kLongestName = 255, kMostFields = 8, kMostOptions = 3, kShownPattern = 80;
constexpr std::size_t kLongestDate = 60, kLongestNumber = 20;

bool has_only(std::string_view text, std::string_view signs) {
  return text.find_first_not_of(signs) == text.npos;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_number(std::string_view text) {
  return is_digit(text.front()) && is_digit(text.back()) && has_only(text, "0123456789-") &&
         text.size() <= kLongestNumber;
}

bool is_email(std::string_view text) {
  const std::size_t sign = text.find('@');
  return sign != text.npos && sign > 0 && text.find(' ') == text.npos &&
         text.find_first_of("_@", sign + 1) == text.npos &&
         text.substr(sign).find('.') != text.npos;
}

bool is_date(std::string_view text) {
  return text.size() <= kLongestDate && written_date(std::string(text)).is_date;
}

// A kind of field, and the texts that it can be. None is empty, but for what a learner called a file.
struct Kind {
  const char* field;
  bool (*may_be)(std::string_view text);
};
constexpr std::array kKinds{
    Kind{"name", [](std::string_view) { return true; }},
    Kind{"plain_name", [](std::string_view text) { return text.find('_') == text.npos; }},
    Kind{"id", [](std::string_view text) { return text.find_first_of("_() ") == text.npos; }},
    Kind{"number", is_number},
    Kind{"email", is_email},
    Kind{"attempt",
         [](std::string_view text) {
           return is_digit(text.front()) && has_only(text, "0123456789.:-");
         }},
    Kind{"date", is_date},
    Kind{"same", [](std::string_view) { return true; }},
    Kind{"any", [](std::string_view text) { return text.find('_') == text.npos; }},
    Kind{"file", [](std::string_view) { return true; }},
    Kind{"ending", [](std::string_view text) { return text.find_first_of("_ ") == text.npos; }},
    Kind{"text", [](std::string_view) { return true; }}};

using Part = NameForm::Part;
using Parts = NameForm::Parts;

// A learner may call these as they like.
bool is_learners(const std::string& field) { return field == "file" || field == "text"; }

bool is_of_files(const Parts& parts) {
  return std::ranges::any_of(parts, is_learners, &Part::field);
}

Parts form_parts(const std::string& pattern) {
  Parts parts;
  for (std::size_t at = 0; at < pattern.size();) {
    if (pattern[at] != '{') {
      const std::size_t end = std::min(pattern.find('{', at), pattern.size());
      parts.push_back({"", pattern.substr(at, end - at)});
      at = end;
      continue;
    }
    const std::size_t end = std::min(pattern.find('}', at), pattern.size());
    const std::string field = pattern.substr(at + 1, end - at - 1);
    if (std::ranges::none_of(kKinds, [&](const Kind& kind) { return field == kind.field; })) {
      std::string all;
      for (const Kind& kind : kKinds) all += fmt::format(" {{{}}}", kind.field);
      throw pt::Error(fmt::format("there is no field {{{}}}; there are{}",
                                  base::printable(field, kShownPattern), all));
    }
    if (!parts.empty() && parts.back().text.empty())
      throw pt::Error("two fields need some text between them");
    parts.push_back({field, ""});
    at = end + 1;
  }
  return parts;
}

void check(const Parts& parts) {
  const auto count = [&](const std::vector<std::string>& fields) {
    return std::ranges::count_if(
        parts, [&](const Part& part) { return std::ranges::count(fields, part.field) > 0; });
  };
  const auto names = count({"name", "plain_name"}), ids = count({"id", "number", "email"});
  if (names + ids == 0) throw pt::Error("it has no {name} and no {id}");
  if (names > 1 || ids > 1 || count({"file", "text"}) > 1 || count({"date"}) > 1 ||
      static_cast<std::size_t>(std::ranges::count(parts, "", &Part::text)) > kMostFields)
    throw pt::Error("it has a field twice, or more than eight");
  const auto same = std::ranges::find(parts, "same", &Part::field);
  const bool is_before_name = same == parts.begin() && parts.size() > 2 && parts[2].field == "name";
  if (same != parts.end() && !is_before_name)
    throw pt::Error("{same} has to be the first field, and {name} the next");
  if (count({"ending"}) > 0 && !is_of_files(parts))
    throw pt::Error("{ending} is that of a {file}, which it does not have");
}

// The pattern with and without each part in [ ].
std::vector<std::string> with_and_without(const std::string& pattern, std::size_t options) {
  const std::size_t open = pattern.find('['), close = pattern.find(']');
  if (open == pattern.npos && close == pattern.npos) return {pattern};
  if (open == pattern.npos || close == pattern.npos || close < open)
    throw pt::Error("a [ needs a ] behind it");
  if (options == 0) throw pt::Error("it has more than three [ ]");
  const std::string before = pattern.substr(0, open), after = pattern.substr(close + 1);
  std::vector<std::string> all =
      with_and_without(before + pattern.substr(open + 1, close - open - 1) + after, options - 1);
  for (std::string& each : with_and_without(before + after, options - 1))
    all.push_back(std::move(each));
  return all;
}

// Finds the values of the fields, each as short or as long as it can be, from the left. A part that failed at a place is not tried there
// again, so that no name takes long.
class Reading {
 public:
  Reading(const Parts& parts, std::string_view name, bool shortest)
      : parts_(parts), name_(name), shortest_(shortest), values_(parts.size()) {}

  bool run(std::size_t part = 0, std::size_t at = 0) {
    if (part == parts_.size()) return at == name_.size();
    if (failed_.contains({part, at})) return false;
    const Part& here = parts_[part];
    if (here.field.empty()) {
      if (name_.substr(at, here.text.size()) == here.text && run(part + 1, at + here.text.size()))
        return true;
    } else if (value_fits(part, at)) {
      return true;
    }
    failed_.insert({part, at});
    return false;
  }

  const std::vector<std::string_view>& values() const { return values_; }

 private:
  bool value_fits(std::size_t part, std::size_t at) {
    const std::string& field = parts_[part].field;
    const auto kind =
        std::ranges::find_if(kKinds, [&](const Kind& each) { return field == each.field; });
    const bool is_last = part + 1 == parts_.size();
    const std::string_view next = is_last ? "" : std::string_view(parts_[part + 1].text);
    const std::size_t least = at + (is_learners(field) ? 0 : 1);
    for (std::size_t i = least; i <= name_.size(); ++i) {
      const std::size_t end = is_last ? name_.size() : shortest_ ? i : name_.size() - (i - least);
      if (end < least || (!is_last && name_.substr(end, next.size()) != next)) continue;
      const std::string_view value = name_.substr(at, end - at);
      // A date is the text up to what follows it.
      const bool is_too_long = field == "date" && !is_last && value.find(next) != value.npos;
      values_[part] = value;
      if (!is_too_long && kind->may_be(value) && run(part + 1, end)) return true;
      if (is_last) return false;
    }
    return false;
  }

  const Parts& parts_;
  std::string_view name_;
  bool shortest_;
  std::vector<std::string_view> values_;
  std::set<std::pair<std::size_t, std::size_t>> failed_;
};

// Numbers of different lengths compare like numbers.
std::string comparable(const std::string& attempt) {
  std::string padded, digits;
  for (const char c : attempt + ' ') {
    if (is_digit(c)) {
      digits += c;
      continue;
    }
    if (!digits.empty()) {
      padded += std::string(kLongestNumber - std::min(kLongestNumber, digits.size()), '0') + digits;
    }
    digits.clear();
  }
  return padded;
}

Label label_of(const NameForm& form, const Parts& parts,
               const std::vector<std::string_view>& values) {
  Label label;
  std::string attempt, ending;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string& field = parts[i].field;
    const std::string value(values[i]);
    if (field == "same") label.name = value + parts[i + 1].text;
    if (field == "name" || field == "plain_name") label.name += value;
    if (field == "id" || field == "number" || field == "email") label.id = value;
    if (is_learners(field)) label.file = value;
    if (field == "ending") ending = "." + value;
    label.text = label.text || field == "text";
    if (field == "attempt") attempt += value + '\n';
    if (field == "date") {
      const WrittenDate date = written_date(value);
      label.dated = value;
      label.handed_in = date.time;
      attempt += date.order + '\n';
    }
  }
  label.file += ending;
  label.attempt = comparable(attempt);
  if (label.name.empty()) label.name = label.id;
  label.key = label.name + '\n' + label.id;
  const std::string platform = lower_case(form.platform);
  if (platform == "moodle") label.platform = Platform::moodle;
  return label;
}

// The ending of an archive, which the platform adds to the name of what it has packed.
std::string packed_ending(const std::string& name) {
  return is_packed(name) ? ending_of(name) : "";
}

}  // namespace

NameForm name_form(const std::string& platform, const std::string& pattern) {
  NameForm form{platform, pattern, {}};
  if (pattern.size() > kLongestName) throw pt::Error("it is too long for a name");
  for (const std::string& each : with_and_without(pattern, kMostOptions)) {
    form.readings.push_back(form_parts(each));
    check(form.readings.back());
  }
  return form;
}

std::vector<NameForm> read_name_forms(const std::string& path) {
  const report::CsvTable table = report::read_csv(pt::read_file(path, kMaxTable), path);
  std::vector<NameForm> forms;
  const std::vector<report::CsvCell> names =
      table.rows.empty() ? std::vector<report::CsvCell>() : table.rows[0].cells;
  const auto column = [&](const char* name) {
    const auto found = std::ranges::find(names, name, &report::CsvCell::value);
    if (found == names.end())
      throw pt::Error(
          fmt::format("{}:1: it has no column '{}'; write platform,pattern", path, name));
    return static_cast<std::size_t>(found - names.begin());
  };
  const std::size_t platform = column("platform"), pattern = column("pattern");
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    const report::CsvRow& row = table.rows[i];
    if (row.cells.size() <= std::max(platform, pattern))
      throw pt::Error(fmt::format("{}:{}: it needs a platform and a pattern", path, row.line));
    const std::string& form = row.cells[pattern].value;
    try {
      forms.push_back(name_form(row.cells[platform].value, form));
    } catch (const std::exception& error) {
      throw pt::Error(fmt::format("{}:{}: '{}': {}", path, row.line,
                                  base::printable(form, kShownPattern), error.what()));
    }
  }
  return forms;
}

std::optional<Label> read_by(const NameForm& form, const std::string& name, bool is_folder) {
  if (name.size() > kLongestName) return std::nullopt;
  for (const Parts& parts : form.readings) {
    const bool is_whole = is_folder || is_of_files(parts);
    const std::string ending = is_whole ? "" : packed_ending(name);
    if (!is_whole && ending.empty()) continue;
    const std::string_view read = std::string_view(name).substr(0, name.size() - ending.size());
    Reading first(parts, read, true), second(parts, read, false);
    if (!first.run()) continue;
    Label label = label_of(form, parts, first.values());
    if (!ending.empty()) label.file = ending;
    if (std::ranges::count(parts, "date", &Part::field) > 0 || !second.run()) return label;
    const Label other = label_of(form, parts, second.values());
    if (other.key != label.key) {
      label.rival_key = other.key;
      label.rival_name = other.name;
      label.rival_id = other.id;
    }
    return label;
  }
  return std::nullopt;
}

std::string between_same_and_name(const NameForm& form) {
  const Parts& parts = form.readings[0];
  return parts[0].field == "same" ? parts[1].text : "";
}

}  // namespace grader::intake
