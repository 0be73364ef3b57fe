#include "grader/service/intake/pieces.h"

#include "grader/service/intake/file_name.h"

#include <algorithm>
#include <map>
#include <regex>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace grader::intake {

namespace fs = std::filesystem;

namespace {

// A file's name without Canvas' resubmission number, and that number. Only task files have such a
// number: part-1.zip and part-2.zip are two files.
std::pair<std::string, int> resubmission(const std::string& name,
                                         const std::vector<TaskFile>& tasks) {
  static const std::regex numbered(R"((.+)-(\d{1,6})(\.[A-Za-z]+))");
  std::smatch found;
  if (!meant_task(name, tasks) || !std::regex_match(name, found, numbered)) return {name, 0};
  return {found[1].str() + found[3].str(), std::stoi(found[2])};
}

// The folder of one attempt: its last folder if it has any, else a copy of its files.
Prepared folder_of(const std::vector<const Piece*>& attempt, const IntakeTools& tools) {
  std::map<std::string, std::pair<int, const Piece*>> counts;
  Prepared result;
  for (const Piece* piece : attempt) {
    if (piece->label.file.empty() && fs::is_directory(piece->path)) result.folder = piece->path;
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
  if (!result.folder.empty()) return result;
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
    return {"", fmt::format(
                    "it has several attempts, and their dates cannot be read ('{}'); keep the last",
                    as_file_name(all[0].label.dated))};
  std::map<std::string, std::vector<const Piece*>> attempts;
  for (const Piece& piece : all) attempts[piece.label.attempt].push_back(&piece);
  std::vector<fs::path> folders;
  std::string note;
  for (const auto& [attempt, pieces] : attempts) {
    Prepared one =
        read_handed_in(name, "", [&pieces = pieces, &tools] { return folder_of(pieces, tools); });
    if (!one.problem.empty()) return one;
    folders.emplace_back(one.folder);
    note = one.note;
  }
  Prepared result = folders.size() == 1 ? prepare_submission(name, folders[0], tools)
                                        : prepare_attempts(name, folders, tools);
  result.note += (note.empty() || result.note.empty() ? "" : "; ") + note;
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
  by.handed_in = last.handed_in;
  if (by.platform != Platform::none) {
    // The platforms identify a file by the text before the learner's own name for it.
    by.feedback = last.before + (last.file.empty() ? "/report.html" : "report.html");
  }
  return by.problem.empty() ? with(by, prepared(by.name, all, tools)) : by;
}

}  // namespace grader::intake
