#include "grader/service/intake/pieces.h"

#include "grader/service/intake/file_name.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace grader::intake {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFirstCounts = "of several attempts the first counts";

// A file's name without Canvas' resubmission number, and that number. Only task files have such a
// number: part-1.zip and part-2.zip are two files.
std::pair<std::string, int> resubmission(const std::string& name,
                                         const std::vector<TaskFile>& tasks) {
  static const std::regex numbered(R"((.+)-(\d{1,6})(\.[A-Za-z]+))");
  std::smatch found;
  if (!meant_task(name, tasks) || !std::regex_match(name, found, numbered)) return {name, 0};
  return {found[1].str() + found[3].str(), std::stoi(found[2])};
}

// The folder of one attempt: its only folder, else a copy of all that it has.
Prepared folder_of(const std::vector<const Piece*>& attempt, const IntakeTools& tools) {
  std::map<std::string, std::pair<int, const Piece*>> counts;
  Prepared result;
  for (const Piece* piece : attempt) {
    const auto [name, number] = resubmission(piece->label.file, tools.tasks);
    auto& [newest, one] = counts[name];
    const Piece* former = one;
    if (one == nullptr || number >= newest) std::tie(newest, one) = std::pair(number, piece);
    if (former != nullptr && !are_equal(former->path, piece->path)) {
      result.note = fmt::format("'{}' counts, and not '{}', which differs",
                                as_file_name(one->path.filename()),
                                as_file_name((one == piece ? former : piece)->path.filename()));
    }
  }
  const Piece& first = *counts.begin()->second.second;
  if (counts.size() == 1 && first.label.file.empty() && fs::is_directory(first.path)) {
    result.folder = first.path;
    return result;
  }
  result.folder = tools.next_folder();
  fs::create_directories(result.folder);
  constexpr auto kAll = fs::copy_options::recursive | fs::copy_options::skip_existing |
                        fs::copy_options::copy_symlinks;
  for (const auto& [name, numbered] : counts) {
    fs::copy(numbered.second->path, fs::path(result.folder) / as_file_name(name), kAll);
  }
  return result;
}

// The date of an attempt may be in a language that read_label does not know.
bool dates_are_unknown(const std::vector<Piece>& all) {
  const auto other = [&](const Piece& piece) { return piece.label.dated != all[0].label.dated; };
  return all[0].label.attempt.empty() && std::any_of(all.begin(), all.end(), other);
}

Prepared prepared(const std::string& name, const std::vector<Piece>& all,
                  const IntakeTools& tools) {
  if (dates_are_unknown(all))
    return {"",
            fmt::format("it has several attempts, and their dates cannot be read ('{}'); keep one",
                        as_file_name(all[0].label.dated))};
  std::map<std::string, std::vector<const Piece*>> attempts;
  for (const Piece& piece : all) attempts[piece.label.attempt].push_back(&piece);
  std::vector<fs::path> folders;
  std::string note;
  const bool are_left_out = tools.attempt == Attempt::first && attempts.size() > 1;
  if (are_left_out) attempts.erase(std::next(attempts.begin()), attempts.end());
  for (const auto& [attempt, pieces] : attempts) {
    Prepared one =
        read_handed_in(name, "", [&pieces = pieces, &tools] { return folder_of(pieces, tools); });
    if (!one.problem.empty()) return one;
    folders.emplace_back(one.folder);
    note = one.note;
  }
  Prepared result = folders.size() == 1 ? prepare_submission(name, folders[0], tools)
                                        : prepare_attempts(name, folders, tools);
  for (const std::string& more : {note, std::string(are_left_out ? kFirstCounts : "")})
    result.note += (more.empty() || result.note.empty() ? "" : "; ") + more;
  return result;
}

}  // namespace

HandedIn with(HandedIn by, const Prepared& prepared) {
  by.folder = prepared.folder;
  by.problem = prepared.problem;
  by.note = prepared.note;
  by.course = prepared.course;
  return by;
}

HandedIn one_submission(Pieces pieces, const IntakeTools& tools) {
  HandedIn& by = pieces.by;
  std::vector<Piece>& all = pieces.all;
  // Text from a form is a submission only if there is nothing else.
  const auto is_text = [](const Piece& each) { return each.label.text; };
  if (!std::all_of(all.begin(), all.end(), is_text)) std::erase_if(all, is_text);
  std::stable_sort(all.begin(), all.end(), [](const Piece& a, const Piece& b) {
    return std::tie(a.label.attempt, a.label.order) < std::tie(b.label.attempt, b.label.order);
  });
  const Label& last = all.back().label;
  by.handed_in = (tools.attempt == Attempt::first ? all.front().label : last).handed_in;
  if (by.platform != Platform::none) {
    // The platforms identify a file by the text before the learner's own name for it.
    by.feedback = last.before + (last.file.empty() ? "/report.html" : "report.html");
  }
  return by.problem.empty() ? with(by, prepared(by.name, all, tools)) : by;
}

}  // namespace grader::intake
