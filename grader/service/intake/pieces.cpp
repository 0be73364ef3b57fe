#include "grader/service/intake/pieces.h"

#include "grader/service/intake/file_name.h"

#include <algorithm>
#include <map>
#include <regex>
#include <string>
#include <tuple>
#include <utility>

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

// A new folder for the files that count.
fs::path copied(const std::vector<Piece>& all, const IntakeTools& tools) {
  std::map<std::string, std::pair<int, const Piece*>> counts;
  for (const Piece& piece : all) {
    const auto [name, number] = resubmission(piece.label.file, tools.tasks);
    auto& [newest, one] = counts[name];
    if (one == nullptr || number >= newest) std::tie(newest, one) = std::pair(number, &piece);
  }
  fs::path folder = tools.next_folder();
  fs::create_directories(folder);
  constexpr auto kAll = fs::copy_options::recursive | fs::copy_options::skip_existing |
                        fs::copy_options::copy_symlinks;
  for (const auto& [name, one] : counts) {
    fs::copy(one.second->path, folder / as_file_name(name), kAll);
  }
  return folder;
}

// The last folder, if there is any.
fs::path last_folder(const std::vector<Piece>& all) {
  const auto last = std::find_if(all.rbegin(), all.rend(),
                                 [](const Piece& each) { return each.label.file.empty(); });
  return last != all.rend() && fs::is_directory(last->path) ? last->path : fs::path();
}

}  // namespace

HandedIn one_submission(Pieces pieces, const IntakeTools& tools) {
  HandedIn& by = pieces.by;
  std::vector<Piece>& all = pieces.all;
  // Text from a form is a submission only if there is nothing else.
  const auto is_text = [](const Piece& each) { return each.label.text; };
  if (!std::all_of(all.begin(), all.end(), is_text)) std::erase_if(all, is_text);
  std::stable_sort(all.begin(), all.end(),
                   [](const Piece& a, const Piece& b) { return a.label.order < b.label.order; });
  const Label& last = all.back().label;
  if (by.platform != Platform::none) {
    // The platforms identify a file by the text before the learner's own name for it.
    by.feedback = last.before + (last.file.empty() ? "/report.html" : "report.html");
  }
  if (!by.problem.empty()) return by;
  by.folder = last_folder(all);
  if (by.folder.empty()) {
    by = with(by, read_handed_in(by.name, "", [&] { return Prepared{copied(all, tools), ""}; }));
  }
  return by.problem.empty() ? with(by, prepare_submission(by.name, by.folder, tools)) : by;
}

}  // namespace grader::intake
