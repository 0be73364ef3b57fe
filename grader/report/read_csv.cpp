#include "grader/report/read_csv.h"

#include "grader/report/csv.h"
#include "pt/error.h"
#include "pt/printable.h"

#include <utility>

#include <fmt/format.h>

namespace grader::report {

namespace {

constexpr std::string_view kSeparators = ",;\t";

class Reader {
 public:
  Reader(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  CsvTable run() {
    check_characters();
    if (text_.starts_with(kByteOrderMark)) at_ = std::string_view(kByteOrderMark).size();
    while (at_ < text_.size()) {
      CsvRow row = next_row();
      const bool is_empty = row.cells.size() == 1 && row.cells[0].size == 0;
      if (!is_empty) table_.rows.push_back(std::move(row));
    }
    return std::move(table_);
  }

 private:
  void check_characters() const {
    int line = 1;
    for (std::size_t at = 0; at < text_.size();) {
      const pt::FirstCharacter next = pt::first_character(text_.substr(at));
      if (next.code < 0) fail(line, "it is not UTF-8; save it as CSV in UTF-8");
      if (next.code == '\n') ++line;
      at += next.size;
    }
  }

  CsvRow next_row() {
    CsvRow row{line_, {}};
    while (true) {
      row.cells.push_back(next_cell());
      if (at_ == text_.size()) return row;
      if (ends_line()) break;
      ++at_;
    }
    const bool two = text_.substr(at_, 2) == "\r\n";
    at_ += two ? 2 : 1;
    ++line_;
    return row;
  }

  CsvCell next_cell() {
    CsvCell cell{{}, at_, 0};
    if (at_ < text_.size() && text_[at_] == '"') {
      cell.value = quotation();
    } else {
      while (!ends_cell()) ++at_;
      cell.value = text_.substr(cell.at, at_ - cell.at);
    }
    cell.size = at_ - cell.at;
    return cell;
  }

  std::string quotation() {
    const int begin = line_;
    std::string value;
    for (++at_; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"') {
        ++at_;
        if (at_ == text_.size() || text_[at_] != '"') {
          if (!ends_cell()) fail(line_, "a cell goes on behind its quotation mark");
          return value;
        }
      }
      if (c == '\n') ++line_;
      value += c;
    }
    fail(begin, "a quotation that begins here does not end");
  }

  bool ends_line() const { return text_[at_] == '\r' || text_[at_] == '\n'; }

  // The first separator found is the separator of the whole table.
  bool ends_cell() {
    if (at_ == text_.size() || ends_line()) return true;
    if (!knows_separator_ && kSeparators.find(text_[at_]) != kSeparators.npos) {
      table_.separator = text_[at_];
      knows_separator_ = true;
    }
    return knows_separator_ && text_[at_] == table_.separator;
  }

  [[noreturn]] void fail(int line, const char* what) const {
    throw pt::Error(fmt::format("{}:{}: {}", path_, line, what));
  }

  std::string_view text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool knows_separator_ = false;
  CsvTable table_;
};

}  // namespace

CsvTable read_csv(std::string_view text, const std::string& path) {
  return Reader(text, path).run();
}

}  // namespace grader::report
