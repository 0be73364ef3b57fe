#include "grader/service/classes/rules.h"

#include "grader/base/printable.h"
#include "grader/service/classes/people_table.h"
#include "grader/service/intake/names_that_differ.h"
#include "grader/service/intake/written_date.h"
#include "grader/service/platforms/worksheet.h"
#include "pt/error.h"
#include "pt/number.h"

#include <algorithm>
#include <ctime>
#include <iterator>
#include <regex>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::classes {

namespace {

constexpr std::int64_t kMinute = 60, kDay = 24 * 60 * kMinute;
constexpr std::size_t kNamed = 5, kShown = 60;
constexpr const char* kTimeForm =
    "write it as 2027-01-15 22:00, or with an offset as in 2027-01-15T22:00+01:00";

std::int64_t time_in(const PeopleRow& row, const char* column, const std::string& path) {
  const std::string& text = row.cells.at(column);
  const auto time = seconds_of(text);
  if (!time) {
    throw pt::Error(fmt::format("{}:{}: '{}' in the column '{}' is no time; {}", path, row.line,
                                base::printable(text, kShown), column, kTimeForm));
  }
  return *time;
}

// The platform that has named most submissions: it gets the rows of those who handed in nothing.
intake::Platform platform_of(const std::vector<intake::HandedIn>& everybody) {
  std::map<intake::Platform, int> count;
  for (const intake::HandedIn& by : everybody) ++count[by.platform];
  const auto most =
      std::ranges::max_element(count, {}, [](const auto& each) { return each.second; });
  return most == count.end() ? intake::Platform::none : most->first;
}

std::string some_of(const std::vector<std::string>& names, bool quiet) {
  if (quiet) return "";
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), kNamed));
  return fmt::format(": {}{}", fmt::join(names.begin(), end, ", "),
                     end == names.end() ? "" : ", ...");
}

// The roster's row of a submission; of a group, the latest times of its members.
struct Listed {
  bool is = false;
  std::optional<std::int64_t> due, handed_in;
};

void compare_with_due(intake::HandedIn& by, std::int64_t due, std::int64_t handed_in, int grace) {
  const std::int64_t over = handed_in - due;
  by.late = over > grace * kMinute;
  by.days_late = by.late ? static_cast<int>((over + kDay - 1) / kDay) : 0;
}

void add(std::string& note, const std::string& more) { note += (note.empty() ? "" : "; ") + more; }

std::string shown_name(const intake::HandedIn& by) { return base::printable(by.name, kShown); }

}  // namespace

Rules rules_for(const RulesAsked& asked, const Rules& earlier) {
  return {asked.roster.value_or(earlier.roster),       asked.due.value_or(earlier.due),
          asked.grace.value_or(earlier.grace),         asked.penalty.value_or(earlier.penalty),
          asked.overrides.value_or(earlier.overrides), asked.attempt.value_or(earlier.attempt)};
}

std::string sentence_of(const Rules& rules) {
  std::vector<std::string> parts;
  if (!rules.roster.empty()) parts.push_back("roster " + rules.roster);
  if (!rules.due.empty()) {
    parts.push_back(fmt::format("due {}, {} minutes of grace, {} % less for each day", rules.due,
                                rules.grace, rules.penalty));
  }
  if (rules.attempt == "first") parts.emplace_back("the first of several attempts counts");
  if (!rules.overrides.empty()) parts.push_back("overrides " + rules.overrides);
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::optional<std::int64_t> seconds_of(const std::string& time) {
  static const std::regex form(
      R"((\d{4})-(\d\d)-(\d\d)[T ](\d\d):(\d\d)(?::(\d\d)(?:\.\d{1,9})?)? ?(Z|UTC|([+-])(\d\d):?(\d\d))?)");
  constexpr std::size_t kMaxTime = 48;
  std::smatch found;
  if (time.size() > kMaxTime || !std::regex_match(time, found, form)) return std::nullopt;
  const auto number = [&](int i) { return found[i].matched ? std::stoi(found[i]) : 0; };
  std::tm parts{};
  parts.tm_year = number(1) - 1900;
  parts.tm_mon = number(2) - 1;
  parts.tm_mday = number(3);
  parts.tm_hour = number(4);
  parts.tm_min = number(5);
  parts.tm_sec = number(6);
  parts.tm_isdst = -1;
  const std::tm asked = parts;
  std::tm in_utc = parts;
  const std::int64_t utc = timegm(&in_utc);
  // timegm makes 1 March of 29 February where there is none.
  const bool is_a_date = in_utc.tm_mday == asked.tm_mday && in_utc.tm_mon == asked.tm_mon &&
                         asked.tm_hour < 24 && asked.tm_min < 60 && asked.tm_sec < 61;
  if (!is_a_date) return std::nullopt;
  if (!found[7].matched) return std::mktime(&parts);
  const int offset = (number(9) * 60 + number(10)) * (found[8] == "-" ? -1 : 1);
  return utc - offset * kMinute;
}

std::vector<std::string> apply_rules(const Rules& rules, std::vector<intake::HandedIn>& everybody,
                                     bool quiet) {
  const auto due = seconds_of(rules.due);
  if (!rules.due.empty() && !due) {
    throw pt::Error(
        fmt::format("--due: '{}' is no time; {}", base::printable(rules.due, kShown), kTimeForm));
  }
  std::vector<PeopleRow> rows;
  if (!rules.roster.empty()) rows = read_people(rules.roster, {"due", "handed_in"});
  const auto places = find_people(rows, everybody, rules.roster);
  std::vector<Listed> listed(everybody.size());
  const intake::Platform platform = platform_of(everybody);
  std::vector<intake::HandedIn> absent;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::optional<std::int64_t> own, handed_in;
    if (rows[i].cells.contains("due")) own = time_in(rows[i], "due", rules.roster);
    if (rows[i].cells.contains("handed_in"))
      handed_in = time_in(rows[i], "handed_in", rules.roster);
    if (!places[i]) {
      intake::HandedIn by{rows[i].name.empty() ? rows[i].id : rows[i].name,
                          rows[i].id,
                          "",
                          false,
                          intake::kNothing,
                          platform};
      by.absent = true;
      absent.push_back(std::move(by));
      continue;
    }
    Listed& one = listed[*places[i]];
    one.is = true;
    one.due = std::max(one.due, own ? own : due);
    one.handed_in = std::max(one.handed_in, handed_in);
  }
  std::vector<std::string> strays, undated, sentences;
  for (std::size_t i = 0; i < everybody.size(); ++i) {
    intake::HandedIn& by = everybody[i];
    const Listed& one = listed[i];
    if (!rules.roster.empty() && !one.is) {
      strays.push_back(shown_name(by));
      add(by.note, "not in the roster");
    }
    const auto until = one.is ? one.due : due;
    const auto from = one.handed_in ? one.handed_in : seconds_of(by.handed_in);
    if (until && from) compare_with_due(by, *until, *from, rules.grace);
    if (until && !from) undated.push_back(shown_name(by));
  }
  if (!strays.empty())
    sentences.push_back(fmt::format("{} has no row for {} of the submissions{}", rules.roster,
                                    strays.size(), some_of(strays, quiet)));
  if (!undated.empty()) {
    sentences.push_back(
        fmt::format("nothing says when {} of the submissions were handed in, so nothing is taken "
                    "off; write it in "
                    "the column 'handed_in' of a roster{}",
                    undated.size(), some_of(undated, quiet)));
  }
  if (!absent.empty()) {
    sentences.push_back(fmt::format("{} of the roster handed in nothing", absent.size()));
    std::ranges::move(absent, std::back_inserter(everybody));
    everybody = intake::with_names_that_differ(std::move(everybody));
  }
  return sentences;
}

void add_times_of_moodle(const std::string& worksheet, std::vector<intake::HandedIn>& everybody) {
  const auto is_of_moodle = [](const intake::HandedIn& by) {
    return by.platform == intake::Platform::moodle;
  };
  std::vector<platforms::GradeRow> rows;
  for (const intake::HandedIn& by : everybody) {
    if (is_of_moodle(by)) rows.push_back({by.name, by.id, false, 0, ""});
  }
  const auto times = platforms::read_worksheet(worksheet).modified(rows);
  for (intake::HandedIn& by : everybody) {
    const auto found = times.find(by.name);
    if (!is_of_moodle(by) || found == times.end()) continue;
    // Of a group, the latest.
    for (const std::string& text : found->second)
      by.handed_in = std::max(by.handed_in, intake::written_date(text).time);
  }
}

std::map<std::size_t, Override> read_overrides(const std::string& path,
                                               const std::vector<intake::HandedIn>& everybody) {
  std::map<std::size_t, Override> all;
  if (path.empty()) return all;
  const std::vector<PeopleRow> rows = read_people(path, {"points", "word"});
  const auto places = find_people(rows, everybody, path);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto fail = [&](const std::string& what) {
      throw pt::Error(fmt::format("{}:{}: {}", path, rows[i].line, what));
    };
    if (!places[i]) fail(fmt::format("'{}' is not in the class", who(rows[i])));
    Override one;
    const auto word = rows[i].cells.find("word"), points = rows[i].cells.find("points");
    if (word != rows[i].cells.end()) one.word = word->second;
    if (points != rows[i].cells.end()) {
      const std::string& text = points->second;
      const auto value = pt::number_in<int>(text);
      if (!value || *value < 0)
        fail(fmt::format("'{}' is not a whole number of points", base::printable(text, kShown)));
      one.points = value;
    }
    if (!one.points && one.word.empty())
      fail(fmt::format("'{}' has no points and no word", who(rows[i])));
    all[*places[i]] = one;
  }
  return all;
}

Grade grade_of(const intake::HandedIn& by, const std::optional<int>& judged, int penalty,
               const Override& by_hand) {
  Grade grade{by.absent ? std::optional(0) : judged, ""};
  if (by_hand.points) {
    grade.points = by_hand.points;
    grade.reason = "by hand";
  } else if (judged && by.days_late > 0 && penalty > 0) {
    const int percent = std::min(100, penalty * by.days_late);
    grade.points = *judged - *judged * percent / 100;
    grade.reason = fmt::format("{} day{} late, {} % less", by.days_late,
                               by.days_late == 1 ? "" : "s", percent);
  }
  if (!by_hand.word.empty()) grade.reason += (grade.reason.empty() ? "" : ": ") + by_hand.word;
  return grade;
}

}  // namespace grader::classes
