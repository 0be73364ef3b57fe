#include "grader/intake/handed_in.h"

#include "grader/base/files.h"
#include "grader/intake/file_name.h"
#include "grader/intake/gradescope.h"
#include "grader/intake/settle.h"
#include "pt/error.h"
#include "pt/printable.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <tuple>

#include <fmt/format.h>

namespace grader::intake {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxAround = 8;  // folders around everything

// Names of files and folders for the class as a whole, beside which the reports lie.
const std::set<std::string>& reserved_names() {
  static const std::set<std::string> names{"class",      "plan",     "compare",  "names",
                                           "canvas",     "moodle",   "feedback", "seed",
                                           "gradescope", "unpacked", "joblog",   "slurm"};
  return names;
}

std::vector<fs::directory_entry> entries_of(const fs::path& folder) {
  std::vector<fs::directory_entry> all;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!base::is_hidden(entry.path().filename())) all.push_back(entry);
  }
  std::sort(all.begin(), all.end());
  return all;
}

bool is_folder(const fs::directory_entry& entry) {
  return entry.is_directory() && !entry.is_symlink();
}

// The name without the ending of an archive.
std::string without_ending(const std::string& name) {
  const std::string stem = fs::path(name).stem();
  return stem.ends_with(".tar") ? stem.substr(0, stem.size() - 4) : stem;
}

// One of the files or folders of a learner.
struct Piece {
  fs::path path;
  Label label;
};

struct Pieces {
  HandedIn by;
  std::vector<Piece> all;
};

// A file's name without Canvas' number of the resubmission, and that number. Only names of tasks
// have one: part-1.zip and part-2.zip are two files.
std::pair<std::string, int> resubmission(const std::string& name,
                                         const std::vector<TaskFile>& tasks) {
  static const std::regex numbered(R"((.+)-(\d{1,6})(\.[A-Za-z]+))");
  std::smatch found;
  if (!meant_task(name, tasks) || !std::regex_match(name, found, numbered)) return {name, 0};
  return {found[1].str() + found[3].str(), std::stoi(found[2])};
}

std::vector<std::string> files_of(const std::vector<fs::directory_entry>& entries) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : entries) {
    if (entry.is_regular_file()) names.push_back(entry.path().filename());
  }
  return names;
}

class Intake {
 public:
  Intake(fs::path work, const std::vector<TaskFile>& tasks, const Unpack& unpack)
      : work_(std::move(work)), means_{tasks, unpack, [this] { return next_folder(); }} {
    fs::remove_all(work_);
  }

  HandedInByAll run(const fs::path& input) {
    const fs::path folder = class_folder(opened(input));
    const std::vector<fs::directory_entry> entries = entries_of(folder);
    if (fs::exists(folder / kGradescopeList)) {
      add_gradescope(folder / kGradescopeList, entries);
    } else {
      is_canvas_ = are_of_canvas(files_of(entries));
      for (const fs::directory_entry& entry : entries) add(entry);
      for (auto& [key, pieces] : pieces_) add_pieces(pieces);
    }
    if (result_.everybody.empty()) {
      throw pt::Error(input.string() +
                      " has no submissions in it: there must be a folder or an archive for each");
    }
    make_names_differ();
    return std::move(result_);
  }

 private:
  // The folder, or that of what is in the archive.
  fs::path opened(const fs::path& input) {
    if (fs::is_directory(input)) return input;
    fs::path folder = work_ / "all";
    fs::create_directories(work_);
    const std::string problem = means_.unpack(input, folder, Extent::everybody);
    if (!problem.empty()) throw pt::Error(problem);
    for (const Fault& fault : read_faults(folder)) {
      faults_.emplace((folder / fault.path).string(), fault.reason);
    }
    return folder;
  }

  // Without the folders around everything.
  fs::path class_folder(fs::path folder) const {
    for (int i = 0; i < kMaxAround; ++i) {
      const std::vector<fs::directory_entry> entries = entries_of(folder);
      if (entries.size() != 1 || !is_folder(entries[0])) return folder;
      const fs::path& inner = entries[0].path();
      if (read_label(inner.filename()) || is_submission(inner, means_.tasks)) return folder;
      const std::vector<fs::directory_entry> inside = entries_of(inner);
      if (inside.empty() || (inside.size() == 1 && !is_folder(inside[0]))) return folder;
      folder = inner;
    }
    return folder;
  }

  // The reason why part of it could not be unpacked; empty if all is there.
  std::string fault_of(const fs::path& path) const {
    const std::string text = path.string(), inside = text + '/';
    for (const auto& [faulty, reason] : faults_) {
      if (faulty == text || faulty.starts_with(inside) || text.starts_with(faulty + '/'))
        return reason;
    }
    return "";
  }

  void add(const fs::directory_entry& entry) {
    const std::string name = entry.path().filename();
    const std::optional<Label> label = read_label(name);
    const bool is_file = entry.is_regular_file() && !entry.is_symlink();
    HandedIn by;
    by.name = name;
    by.problem = fault_of(entry.path());
    if (entry.is_symlink()) {
      by.problem = "it is a link; copy what it points to";
      result_.everybody.push_back(by);
    } else if (!is_folder(entry) && !is_file) {
      return;  // a pipe, a device: no platform exports one
    } else if (label && (label->platform != Platform::canvas || (is_canvas_ && is_file))) {
      add_piece({entry.path(), *label});
    } else if (is_folder(entry)) {
      by.folder = entry.path();
      if (by.problem.empty()) settle(by, means_);
      result_.everybody.push_back(by);
    } else if (is_packed(name) || !by.problem.empty()) {
      by.name = is_packed(name) ? without_ending(name) : name;
      if (by.problem.empty()) add_archive(by, entry.path());
      result_.everybody.push_back(by);
    } else {
      result_.unclaimed.push_back(name);
    }
  }

  void add_archive(HandedIn& by, const fs::path& file) const {
    if (is_archive(file.filename())) {
      settle_archive(by, file, means_);
    } else {
      by.problem =
          fmt::format("'{}' cannot be unpacked here; hand in a zip", as_file_name(file.filename()));
    }
  }

  void add_piece(const Piece& piece) {
    Pieces& pieces = pieces_[piece.label.key()];
    HandedIn& by = pieces.by;
    by.name = piece.label.name;
    by.id = piece.label.id;
    by.late = by.late || piece.label.late;
    by.platform = piece.label.platform;
    if (by.problem.empty()) by.problem = fault_of(piece.path);
    pieces.all.push_back(piece);
  }

  // Words in a form are a submission only where there is nothing else.
  void add_pieces(Pieces& pieces) {
    HandedIn& by = pieces.by;
    std::vector<Piece>& all = pieces.all;
    const auto is_text = [](const Piece& each) { return each.label.text; };
    if (!std::all_of(all.begin(), all.end(), is_text)) std::erase_if(all, is_text);
    std::stable_sort(all.begin(), all.end(),
                     [](const Piece& a, const Piece& b) { return a.label.order < b.label.order; });
    const Label& last = all.back().label;
    if (by.platform != Platform::none) {
      // The platforms know files by what stands before the name that the learner gave them.
      by.feedback = last.before + (last.file.empty() ? "/report.html" : "report.html");
    }
    if (by.problem.empty()) gather(by, all);
    result_.everybody.push_back(by);
  }

  // A folder of their own for the files that count; or the last of the folders that there are.
  void gather(HandedIn& by, const std::vector<Piece>& all) {
    const auto is_file = [](const Piece& each) { return !each.label.file.empty(); };
    if (!std::all_of(all.begin(), all.end(), is_file)) {
      const auto last = std::find_if_not(all.rbegin(), all.rend(), is_file);
      if (fs::is_directory(last->path)) by.folder = last->path;
    }
    if (by.folder.empty()) or_problem(by, [&] { by.folder = copied(all); });
    if (by.problem.empty()) settle(by, means_);
  }

  fs::path copied(const std::vector<Piece>& all) {
    std::map<std::string, std::pair<int, const Piece*>> counts;
    for (const Piece& piece : all) {
      const auto [name, number] = resubmission(piece.label.file, means_.tasks);
      auto& [newest, one] = counts[name];
      if (one == nullptr || number >= newest) std::tie(newest, one) = std::pair(number, &piece);
    }
    const fs::path folder = next_folder();
    fs::create_directories(folder);
    constexpr auto kAll = fs::copy_options::recursive | fs::copy_options::skip_existing |
                          fs::copy_options::copy_symlinks;
    for (const auto& [name, one] : counts) {
      fs::copy(one.second->path, folder / as_file_name(name), kAll);
    }
    return folder;
  }

  void add_gradescope(const fs::path& list, const std::vector<fs::directory_entry>& entries) {
    std::map<std::string, Submitters> listed = read_gradescope_list(list);
    std::map<std::string, fs::path> folders;
    for (const fs::directory_entry& entry : entries) {
      if (!is_folder(entry)) continue;
      folders[entry.path().filename()] = entry.path();
      listed.try_emplace(entry.path().filename());
    }
    for (const auto& [folder, who] : listed) {
      HandedIn by;
      by.name = who.names.empty() ? folder : who.names;
      by.id = who.ids;
      by.platform = Platform::gradescope;
      const auto place = folders.find(folder);
      if (place == folders.end()) {
        by.problem = "the list of submissions names it, and the export has no folder for it";
      } else {
        by.folder = place->second;
        by.problem = fault_of(place->second);
      }
      if (by.problem.empty()) settle(by, means_);
      result_.everybody.push_back(by);
    }
  }

  fs::path next_folder() {
    fs::create_directories(work_);
    return work_ / std::to_string(++folders_);
  }

  // Reports are named by them.
  void make_names_differ() {
    std::vector<HandedIn>& all = result_.everybody;
    for (HandedIn& each : all) each.name = as_file_name(each.name);
    std::map<std::string, int> count;
    for (const HandedIn& each : all) ++count[folded(each.name)];
    // A name with marks has to differ from those that have theirs in the letter.
    std::stable_partition(all.begin(), all.end(),
                          [](const HandedIn& each) { return !has_marks(each.name); });
    std::set<std::string> used = reserved_names(), plain;
    const auto is_new = [&](const std::string& name) {
      const std::string key = folded(name), without = accents_alike(key);
      if (has_marks(name)) return !plain.contains(without) && used.insert(key).second;
      plain.insert(without);
      return used.insert(key).second;
    };
    for (HandedIn& each : all) {
      if (count[folded(each.name)] > 1 && !each.id.empty())
        each.name += " (" + as_file_name(std::string(pt::beginning(each.id, 30))) + ")";
      std::string name = each.name;
      for (int i = 2; !is_new(name); ++i) name = fmt::format("{} ({})", each.name, i);
      each.name = name;
      if (each.platform == Platform::none) each.feedback = name + ".html";
    }
    std::sort(all.begin(), all.end(),
              [](const HandedIn& a, const HandedIn& b) { return a.name < b.name; });
  }

  fs::path work_;
  Means means_;
  int folders_ = 0;
  bool is_canvas_ = false;
  std::map<std::string, std::string> faults_;  // by path
  std::map<std::string, Pieces> pieces_;
  HandedInByAll result_;
};

}  // namespace

HandedInByAll handed_in(const std::string& input, const std::string& work,
                        const std::vector<TaskFile>& tasks, const Unpack& unpack) {
  return Intake(work, tasks, unpack).run(input);
}

}  // namespace grader::intake
