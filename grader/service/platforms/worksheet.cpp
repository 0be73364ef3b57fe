#include "grader/service/platforms/worksheet.h"

#include "grader/report/csv.h"
#include "grader/results/presentable.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/number.h"
#include "pt/printable.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace grader::platforms {

using report::CsvCell;
using report::CsvRow;

namespace {

constexpr std::size_t kMaxWorksheet = std::size_t{64} << 20;  // bytes
constexpr std::size_t kNone = std::string::npos;              // a missing column

// The number in "Participant 123"; empty if the text does not end in a number.
std::string number_of(const CsvCell& identifier) {
  return identifier.value.substr(identifier.value.find_last_not_of("0123456789") + 1);
}

// "100.00", or "100,00" from a spreadsheet.
std::optional<double> points_in(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  return pt::number_in<double>(text);
}

// A name in a form in which Moodle's names of files and its table agree: letters and digits of ASCII
// alone, if it has any.
std::string plain(const std::string& name) {
  std::string text;
  for (std::size_t at = 0; at < name.size();) {
    const pt::FirstCharacter next = pt::first_character(std::string_view(name).substr(at));
    const bool is_mark = next.code >= 0x300 && next.code <= 0x36f;  // on the letter before it
    if (is_mark && !text.empty()) text.pop_back();
    const bool is_ascii = next.code > 0 && next.code < 0x80;
    if (is_ascii && std::isalnum(next.code) != 0)
      text += static_cast<char>(std::tolower(next.code));
    at += next.size;
  }
  return text.empty() ? name : text;
}

// The name as Moodle wrote it: that of a report may have the ID behind it, as in "Ada (55)".
std::string name_of(const GradeRow& row) {
  const std::string behind = " (" + row.id + ")";
  const bool has_id = !row.id.empty() && row.name.ends_with(behind);
  return has_id ? row.name.substr(0, row.name.size() - behind.size()) : row.name;
}

// The submissions that may be those of a group. The whole name decides, and the plain one only where
// no other group of the class has it.
std::vector<const GradeRow*> submissions_of(const std::string& group,
                                            const std::set<std::string>& groups,
                                            const std::vector<const GradeRow*>& submissions) {
  std::vector<const GradeRow*> equal, alike;
  for (const GradeRow* each : submissions) {
    const std::string name = name_of(*each);
    if (name == group) equal.push_back(each);
    if (plain(name) == plain(group) && !groups.contains(name)) alike.push_back(each);
  }
  if (!equal.empty()) return equal;
  const auto namesakes = std::ranges::count_if(
      groups, [&](const std::string& other) { return plain(other) == plain(group); });
  // One submission and two groups: it may be that of either.
  if (namesakes > 1 && alike.size() == 1) alike.push_back(alike[0]);
  return alike;
}

std::string shown(const CsvCell& cell) {
  constexpr std::size_t kMaxShown = 60;
  return std::string(pt::beginning(results::one_line(cell.value), kMaxShown));
}

}  // namespace

Worksheet::Worksheet(std::string text, std::string path)
    : text_(std::move(text)),
      path_(std::move(path)),
      table_(report::read_csv(text_, path_)),
      identifier_(column("Identifier")),
      grade_(column("Grade")),
      maximum_(column("Maximum Grade")),
      can_change_(column("Grade can be changed")),
      comment_(column("Feedback comments", false)),
      name_(column("Full name", false)),
      group_(column("Group", false)),
      modified_(column("Last modified (submission)", false)) {
  std::set<std::string> known;
  for (std::size_t i = 1; i < table_.rows.size(); ++i) {
    const CsvRow& row = table_.rows[i];
    check(row);
    const CsvCell& identifier = row.cells[identifier_];
    if (!known.insert(number_of(identifier)).second)
      fail(row.line, fmt::format("'{}' has a row already; remove one", shown(identifier)));
  }
}

std::size_t Worksheet::column(const char* name, bool must_be) const {
  if (table_.rows.empty()) fail(1, "it is empty; download the grading worksheet again");
  const std::vector<CsvCell>& names = table_.rows[0].cells;
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const CsvCell& cell) { return cell.value == name; });
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  if (!must_be) return kNone;
  fail(table_.rows[0].line,
       fmt::format("it has no column '{}'; download the grading worksheet with Moodle in English",
                   name));
}

void Worksheet::check(const CsvRow& row) const {
  const std::size_t columns = table_.rows[0].cells.size();
  if (row.cells.size() != columns) {
    fail(row.line, fmt::format("it has {} cells, and the first line {}; download the grading "
                               "worksheet again",
                               row.cells.size(), columns));
  }
  if (number_of(row.cells[identifier_]).empty()) {
    fail(row.line,
         fmt::format("'{}' is not a participant ('Participant 123'); download the grading "
                     "worksheet again",
                     shown(row.cells[identifier_])));
  }
}

void Worksheet::check_maximum(const CsvRow& row, int max_points) const {
  const CsvCell& maximum = row.cells[maximum_];
  if (points_in(maximum.value) == static_cast<double>(max_points)) return;
  fail(row.line,
       fmt::format("Moodle's maximum is '{}', and there are {} points; make {} the maximum "
                   "grade of the assignment, and download the grading worksheet again",
                   shown(maximum), max_points, max_points));
}

// Moodle may write the name of a group before that of a learner.
bool Worksheet::is_of(const GradeRow& learner, const CsvRow& row) const {
  return group_ == kNone || name_ == kNone ||
         plain(name_of(learner)).ends_with(plain(row.cells[name_].value));
}

Worksheet::Matches Worksheet::matches(const std::vector<GradeRow>& rows) const {
  std::map<std::string, const GradeRow*> learners;
  for (const GradeRow& row : rows) {
    if (!row.id.empty()) learners[row.id] = &row;
  }
  Matches found;
  std::vector<std::pair<const CsvRow*, std::string>> members;  // of a group with this name
  std::set<const GradeRow*> taken;
  std::set<std::string> names;
  for (std::size_t i = 1; i < table_.rows.size(); ++i) {
    const CsvRow& row = table_.rows[i];
    const auto one = learners.find(number_of(row.cells[identifier_]));
    if (one != learners.end() && is_of(*one->second, row)) {
      found.all.push_back({&row, one->second, true});
      taken.insert(one->second);
    } else if (group_ != kNone && !row.cells[group_].value.empty()) {
      members.emplace_back(&row, row.cells[group_].value);
      names.insert(members.back().second);
    }
  }
  // The work of one learner alone is nobody else's, whatever the learner's name is.
  std::vector<const GradeRow*> left;
  for (const GradeRow& row : rows) {
    if (!taken.contains(&row)) left.push_back(&row);
  }
  std::map<std::string, const GradeRow*> groups;
  for (const std::string& name : names) {
    const std::vector<const GradeRow*> fitting = submissions_of(name, names, left);
    if (fitting.size() == 1) groups[name] = fitting[0];
    if (fitting.size() > 1) found.unclear.push_back(name);
  }
  for (const auto& [row, name] : members) {
    if (const auto group = groups.find(name); group != groups.end())
      found.all.push_back({row, group->second, false});
  }
  std::ranges::sort(found.all, {}, [](const Match& match) { return match.row; });
  return found;
}

std::map<std::string, std::vector<std::string>> Worksheet::pages(
    const std::vector<GradeRow>& rows,
    const std::function<std::string(const GradeRow&)>& path_of) const {
  std::map<std::string, std::vector<std::string>> all;
  for (const Match& match : matches(rows).all) {
    const std::string number = number_of(match.row->cells[identifier_]);
    all[match.learner->name].push_back(
        match.alone ? path_of(*match.learner)
                    : fmt::format("Participant_{}_assignsubmission_file_/report.html", number));
  }
  return all;
}

std::map<std::string, std::vector<std::string>> Worksheet::modified(
    const std::vector<GradeRow>& rows) const {
  std::map<std::string, std::vector<std::string>> all;
  if (modified_ == kNone) return all;
  for (const Match& match : matches(rows).all)
    all[match.learner->name].push_back(match.row->cells[modified_].value);
  return all;
}

Worksheet::Filled Worksheet::filled(const std::vector<GradeRow>& rows, int max_points) const {
  std::set<const GradeRow*> strays;
  for (const GradeRow& row : rows) strays.insert(&row);
  Filled filled;
  std::size_t copied = 0;
  const auto put = [&](const CsvCell& cell, const std::string& value) {
    filled.text += text_.substr(copied, cell.at - copied) + value;
    copied = cell.at + cell.size;
  };
  const Matches found = matches(rows);
  filled.unclear = found.unclear;
  for (const Match& match : found.all) {
    const CsvRow& row = *match.row;
    const GradeRow& learner = *match.learner;
    strays.erase(&learner);
    if (row.cells[can_change_].value == "No") {
      ++filled.locked;
      continue;
    }
    std::map<std::size_t, std::string> values;  // new cells, by column
    if (learner.judged) {
      check_maximum(row, max_points);
      values[grade_] = std::to_string(std::min(learner.points, max_points));
    }
    if (comment_ != kNone && !learner.comment.empty())
      values[comment_] = report::csv_field(learner.comment);
    for (const auto& [column, value] : values) put(row.cells[column], value);
  }
  filled.text += text_.substr(copied);
  for (const GradeRow& row : rows) {
    if (strays.contains(&row)) filled.strays.push_back(row.name);
  }
  return filled;
}

void Worksheet::fail(int line, const std::string& what) const {
  throw pt::Error(fmt::format("{}:{}: {}", path_, line, what));
}

Worksheet read_worksheet(const std::string& path) {
  return {pt::read_file(path, kMaxWorksheet), path};
}

}  // namespace grader::platforms
