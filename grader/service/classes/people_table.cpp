#include "grader/service/classes/people_table.h"

#include "grader/base/printable.h"
#include "grader/report/read_csv.h"
#include "grader/service/intake/file_name.h"
#include "grader/service/intake/names_that_differ.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace grader::classes {

namespace {

constexpr std::size_t kMaxTable = std::size_t{64} << 20;  // bytes
constexpr std::size_t kMaxShown = 60;

[[noreturn]] void fail(const std::string& path, int line, const std::string& what) {
  throw pt::Error(fmt::format("{}:{}: {}", path, line, what));
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == text.npos ? "" : text.substr(first, last - first + 1);
}

// The name that the platform has: that of a report may have the ID behind it, as in "Ada (55)".
std::string name_of(const intake::HandedIn& by) {
  const std::string behind = " (" + by.id + ")";
  const bool has_id = !by.id.empty() && by.name.ends_with(behind);
  return has_id ? by.name.substr(0, by.name.size() - behind.size()) : by.name;
}

// Without a platform, the name of a folder is what a roster may call the ID.
std::set<std::string> keys_of(const intake::HandedIn& by) {
  return by.id.empty() ? std::set<std::string>{name_of(by)} : intake::ids_of(by);
}

// Rows to their submissions: by ID, by name, and by a name that is alike.
class Finder {
 public:
  Finder(const std::vector<PeopleRow>& rows, const std::vector<intake::HandedIn>& everybody,
         const std::string& path)
      : rows_(rows),
        everybody_(everybody),
        path_(path),
        found_(rows.size()),
        owners_(everybody.size()) {
    for (std::size_t i = 0; i < everybody.size(); ++i) {
      for (const std::string& id : keys_of(everybody[i])) by_id_[id].push_back(i);
      by_name_[name_of(everybody[i])].push_back(i);
      by_likeness_[alike(name_of(everybody[i]))].push_back(i);
    }
  }

  std::vector<std::optional<std::size_t>> run() {
    for (std::size_t row = 0; row < rows_.size(); ++row) claim(row, by_id_, rows_[row].id, true);
    for (std::size_t row = 0; row < rows_.size(); ++row) claim(row, by_name_, rows_[row].name);
    for (std::size_t row = 0; row < rows_.size(); ++row)
      claim(row, by_likeness_, alike(rows_[row].name));
    return std::move(found_);
  }

 private:
  using Places = std::map<std::string, std::vector<std::size_t>>;

  static std::string alike(const std::string& name) {
    return intake::accents_alike(intake::folded(name));
  }

  void claim(std::size_t row, const Places& places, const std::string& key, bool by_id = false) {
    const auto at = places.find(key);
    if (found_[row] || key.empty() || at == places.end()) return;
    std::vector<std::size_t> fitting;
    for (const std::size_t i : at->second) {
      const bool has_another_id = !rows_[row].id.empty() && !everybody_[i].id.empty();
      const bool is_taken = &places == &by_likeness_ && owners_[i] != nullptr;
      if (by_id || (!has_another_id && !is_taken)) fitting.push_back(i);
    }
    if (fitting.empty()) return;
    if (fitting.size() > 1) {
      fail(path_, rows_[row].line,
           fmt::format("'{}' may be '{}' or '{}'; write the ID", who(rows_[row]),
                       everybody_[fitting[0]].name, everybody_[fitting[1]].name));
    }
    const PeopleRow*& owner = owners_[fitting[0]];
    const bool is_group = intake::ids_of(everybody_[fitting[0]]).size() > 1;
    if (owner != nullptr && !is_group) {
      fail(path_, rows_[row].line,
           fmt::format("'{}' and '{}' in line {} are both '{}'; write their IDs", who(rows_[row]),
                       who(*owner), owner->line, everybody_[fitting[0]].name));
    }
    owner = &rows_[row];
    found_[row] = fitting[0];
  }

  const std::vector<PeopleRow>& rows_;
  const std::vector<intake::HandedIn>& everybody_;
  const std::string& path_;
  std::vector<std::optional<std::size_t>> found_;
  std::vector<const PeopleRow*> owners_;  // the first row that means a submission
  Places by_id_, by_name_, by_likeness_;
};

}  // namespace

std::string who(const PeopleRow& row) {
  return base::printable(row.name.empty() ? row.id : row.name, kMaxShown);
}

std::vector<PeopleRow> read_people(const std::string& path,
                                   const std::vector<std::string>& others) {
  const report::CsvTable table = report::read_csv(pt::read_file(path, kMaxTable), path);
  if (table.rows.empty()) fail(path, 1, "it is empty; its first line has to name the columns");
  std::vector<std::string> columns;
  for (const report::CsvCell& cell : table.rows[0].cells)
    columns.push_back(intake::lower_case(trimmed(cell.value)));
  const auto has = [&](const char* name) { return std::ranges::count(columns, name) > 0; };
  if (!has("id") && !has("name"))
    fail(path, table.rows[0].line, "it has no column 'id' and none 'name'; write one of them");
  std::vector<PeopleRow> rows;
  std::map<std::string, int> known;
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    const report::CsvRow& from = table.rows[i];
    if (from.cells.size() > columns.size()) {
      fail(
          path, from.line,
          fmt::format("it has {} cells, and the first line {}", from.cells.size(), columns.size()));
    }
    PeopleRow row{from.line, "", "", {}};
    for (std::size_t column = 0; column < from.cells.size(); ++column) {
      const std::string value = trimmed(from.cells[column].value);
      if (columns[column] == "id") row.id = value;
      if (columns[column] == "name") row.name = value;
      if (!value.empty() && std::ranges::count(others, columns[column]) > 0)
        row.cells[columns[column]] = value;
    }
    if (row.id.empty() && row.name.empty())
      fail(path, row.line, "it names nobody; write an id or a name");
    const std::string key = row.id.empty() ? "name " + row.name : "id " + row.id;
    const auto [entry, is_new] = known.try_emplace(key, row.line);
    if (!is_new)
      fail(path, row.line,
           fmt::format("'{}' has line {} already; remove one", who(row), entry->second));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::optional<std::size_t>> find_people(const std::vector<PeopleRow>& rows,
                                                    const std::vector<intake::HandedIn>& everybody,
                                                    const std::string& path) {
  return Finder(rows, everybody, path).run();
}

}  // namespace grader::classes
