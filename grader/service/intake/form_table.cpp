#include "grader/service/intake/form_table.h"

#include "grader/base/printable.h"
#include "grader/report/read_csv.h"
#include "grader/service/intake/owner.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace grader::intake {

namespace {

constexpr std::size_t kMaxTable = std::size_t{1} << 20;  // bytes
constexpr std::size_t kLongestName = 255, kMostFields = 8, kShownPattern = 80;

// The regular expression of each field; a `?` behind it makes it short.
const std::map<std::string, std::string>& kinds() {
  static const std::map<std::string, std::string> all{{"name", ".+"},
                                                      {"id", "[^_() ]+"},
                                                      {"attempt", "[0-9][0-9.:-]*"},
                                                      {"file", ".+"},
                                                      {"any", "[^_]+"}};
  return all;
}

NameForm form_of(const std::string& platform, const std::string& pattern) {
  NameForm form{platform, {}, {}, {}};
  std::string shortest, longest;
  for (std::size_t at = 0; at < pattern.size();) {
    if (pattern[at] != '{') {
      const std::string sign = std::string("\\") + pattern[at];
      const bool is_plain = std::isalnum(static_cast<unsigned char>(pattern[at])) != 0 ||
                            (pattern[at] & 0x80) != 0 || pattern[at] == '_' || pattern[at] == ' ';
      shortest += is_plain ? pattern.substr(at, 1) : sign;
      longest += is_plain ? pattern.substr(at, 1) : sign;
      ++at;
      continue;
    }
    const std::size_t end = std::min(pattern.find('}', at), pattern.size());
    const std::string field = pattern.substr(at + 1, end - at - 1);
    const auto kind = kinds().find(field);
    if (kind == kinds().end())
      throw pt::Error(
          fmt::format("there is no field {{{}}}; there are {{name}}, {{id}}, {{attempt}}, "
                      "{{file}} and {{any}}",
                      base::printable(field, kShownPattern)));
    if (at > 0 && pattern[at - 1] == '}') throw pt::Error("two fields need some text between them");
    form.fields.push_back(field);
    shortest += "(" + kind->second + "?)";
    longest += "(" + kind->second + ")";
    at = end + 1;
  }
  const auto count = [&](const char* field) { return std::ranges::count(form.fields, field); };
  if (count("name") + count("id") == 0) throw pt::Error("it has no {name} and no {id}");
  if (form.fields.size() > kMostFields || count("name") > 1 || count("id") > 1 || count("file") > 1)
    throw pt::Error("it has a field twice, or more than eight");
  form.shortest = std::regex(shortest);
  form.longest = std::regex(longest);
  return form;
}

Label label_of(const NameForm& form, const std::smatch& found) {
  Label label;
  for (std::size_t i = 0; i < form.fields.size(); ++i) {
    const std::string& field = form.fields[i];
    const std::string value = found[i + 1];
    if (field == "name") label.name = value;
    if (field == "id") label.id = value;
    if (field == "file") label.file = value;
    if (field == "attempt") label.attempt += value + '\n';
  }
  // Numbers of different lengths compare like numbers.
  std::string padded, digits;
  for (const char c : label.attempt + ' ') {
    if (c >= '0' && c <= '9') {
      digits += c;
      continue;
    }
    if (!digits.empty())
      padded += std::string(20 - std::min<std::size_t>(20, digits.size()), '0') + digits;
    digits.clear();
  }
  label.attempt = padded;
  if (label.name.empty()) label.name = label.id;
  label.key = label.name + '\n' + label.id;
  return label;
}

}  // namespace

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
      forms.push_back(form_of(row.cells[platform].value, form));
    } catch (const std::exception& error) {
      throw pt::Error(fmt::format("{}:{}: '{}': {}", path, row.line,
                                  base::printable(form, kShownPattern), error.what()));
    }
  }
  return forms;
}

std::optional<Label> read_by(const NameForm& form, const std::string& name) {
  std::smatch first, second;
  if (name.size() > kLongestName || !std::regex_match(name, first, form.shortest) ||
      !std::regex_match(name, second, form.longest))
    return std::nullopt;
  Label label = label_of(form, first);
  const Label other = label_of(form, second);
  if (other.key != label.key) {
    label.rival_key = other.key;
    label.rival_name = other.name;
    label.rival_id = other.id;
  }
  return label;
}

}  // namespace grader::intake
