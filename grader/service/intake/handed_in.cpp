#include "grader/service/intake/handed_in.h"

#include "grader/base/files.h"
#include "grader/service/intake/file_name.h"
#include "grader/service/intake/gradescope.h"
#include "grader/service/intake/names_that_differ.h"
#include "grader/service/intake/pieces.h"
#include "grader/service/intake/prepare_submission.h"
#include "grader/service/intake/unpack.h"
#include "pt/error.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace grader::intake {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxAround = 8;  // leading folders that everything shares

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

bool is_file(const fs::directory_entry& entry) {
  return entry.is_regular_file() && !entry.is_symlink();
}

// The name without the ending of an archive.
std::string without_ending(const std::string& name) {
  const std::string stem = fs::path(name).stem();
  return stem.ends_with(".tar") ? stem.substr(0, stem.size() - 4) : stem;
}

Labels labels_of(const std::vector<fs::directory_entry>& entries,
                 const std::vector<NameForm>& table) {
  std::vector<std::string> files, folders;
  for (const fs::directory_entry& entry : entries) {
    if (is_file(entry)) files.push_back(entry.path().filename());
    if (is_folder(entry)) folders.push_back(entry.path().filename());
  }
  return {files, folders, table};
}

class Intake {
 public:
  Intake(fs::path work, const std::vector<TaskFile>& tasks, const Readers& readers,
         const std::vector<NameForm>& table, const Progress& progress, Attempt attempt)
      : work_(std::move(work)),
        tools_{tasks, readers, [this] { return next_folder(); }, attempt},
        table_(table),
        progress_(progress) {
    fs::remove_all(work_);
  }

  HandedInByAll run(const fs::path& input) {
    const fs::path folder = class_folder(opened(input));
    const std::vector<fs::directory_entry> entries = entries_of(folder);
    if (fs::exists(folder / kGradescopeList)) {
      add_gradescope(folder / kGradescopeList, entries);
    } else {
      labels_ = labels_of(entries, table_);
      add_all(entries);
    }
    if (result_.everybody.empty()) {
      throw pt::Error(input.string() +
                      " has no submissions in it: there must be a folder or an archive for each");
    }
    name_hidden(folder);
    result_.everybody = with_names_that_differ(with_ids_that_differ(std::move(result_.everybody)));
    return std::move(result_);
  }

 private:
  // The folder, or the folder of the unpacked archive.
  fs::path opened(const fs::path& input) {
    if (fs::is_directory(input)) return input;
    fs::path folder = work_ / "all";
    fs::create_directories(work_);
    const std::string problem = tools_.readers.unpack(input, folder, Extent::everybody);
    if (!problem.empty()) throw pt::Error(problem);
    for (const Fault& fault : read_faults(folder)) {
      faults_.emplace((folder / fault.path).string(), fault.reason);
    }
    return folder;
  }

  // The folder without the leading folders that everything shares.
  fs::path class_folder(fs::path folder) const {
    for (int i = 0; i < kMaxAround; ++i) {
      const std::vector<fs::directory_entry> entries = entries_of(folder);
      if (entries.size() != 1 || !is_folder(entries[0])) return folder;
      const fs::path& inner = entries[0].path();
      if (labels_of(entries, table_).of(inner.filename())) return folder;
      const std::vector<fs::directory_entry> inside = entries_of(inner);
      const bool has_one = inside.size() == 1;
      const bool of_platform = has_one && labels_of(inside, table_).of(inside[0].path().filename());
      const bool is_class = of_platform || holds_several(inner, tools_.tasks);
      if (is_submission(inner, tools_.tasks) && !is_class) return only_submission(folder, inner);
      if (inside.empty() || (has_one && !is_folder(inside[0]) && !is_class)) return folder;
      folder = inner;
    }
    return folder;
  }

  // A folder as Google Drive packs it has the files of all learners, without their names.
  fs::path only_submission(const fs::path& folder, const fs::path& inner) const {
    const std::string slug = numbered_twice(inner, tools_.tasks);
    if (slug.empty()) return folder;
    throw pt::Error(fmt::format(
        "{} has several files that mean {}.cpp, and does not say whose they are; put the files of "
        "each learner in a folder with the learner's name",
        inner.filename().string(), slug));
  }

  // The reason why part of it could not be unpacked; empty if nothing is missing.
  std::string fault_of(const fs::path& path) const {
    const std::string text = path.string(), inside = text + '/';
    for (const auto& [faulty, reason] : faults_) {
      if (faulty == text || faulty.starts_with(inside) || text.starts_with(faulty + '/'))
        return reason;
    }
    return "";
  }

  void add_all(const std::vector<fs::directory_entry>& entries) {
    std::vector<fs::directory_entry> alone;
    for (const fs::directory_entry& entry : entries) {
      const std::optional<Label> label = labels_.of(entry.path().filename());
      if (label) add_piece({entry.path(), *label});
      if (!label) alone.push_back(entry);
    }
    for (const fs::directory_entry& entry : alone) {
      if (is_handed_in(entry)) ++claims_[learner_of(entry)];
    }
    start(alone.size() + pieces_.size());
    for (const fs::directory_entry& entry : alone) {
      add(entry);
      count();
    }
    for (auto& [key, pieces] : pieces_) note_rivals(pieces);
    for (auto& [key, pieces] : pieces_) {
      result_.everybody.push_back(one_submission(std::move(pieces), tools_));
      count();
    }
  }

  // A file that may be that of another learner is nobody's.
  void note_rivals(const Pieces& pieces) {
    for (const Piece& piece : pieces.all) {
      if (piece.label.rival_key.empty()) continue;
      for (const std::string& key : {piece.label.key, piece.label.rival_key}) {
        const auto one = pieces_.find(key);
        if (one == pieces_.end()) continue;
        one->second.by.problem = fmt::format(
            "'{}' may be a file of '{}' with the ID {}, or of '{}' with the ID {}: ask whose it "
            "is, and rename it",
            as_file_name(piece.path.filename()), as_file_name(piece.label.name), piece.label.id,
            as_file_name(piece.label.rival_name), piece.label.rival_id);
      }
    }
  }

  void start(std::size_t all) {
    all_ = all;
    progress_(0, all);
  }

  void count() { progress_(++done_, all_); }

  void add(const fs::directory_entry& entry) {
    const std::string name = entry.path().filename();
    HandedIn by;
    by.name = name;
    by.problem = fault_of(entry.path());
    const std::string learner = learner_of(entry);
    const bool is_one_of_two = is_handed_in(entry) && claims_[learner] > 1;
    if (is_one_of_two && by.problem.empty()) {
      by.problem = fmt::format(
          "there is another '{}', in a folder or an archive, and nobody knows whose work is whose: "
          "keep one, or give each the name of its learner",
          as_file_name(learner));
    }
    if (entry.is_symlink()) {
      by.problem = "it is a link; copy what it points to";
      result_.everybody.push_back(by);
    } else if (is_folder(entry)) {
      by.folder = entry.path();
      add_prepared(by);
    } else if (is_file(entry) && (is_packed(name) || !by.problem.empty())) {
      by.name = is_one_of_two ? name : learner;
      if (by.problem.empty()) by = with(by, prepare_submission(by.name, entry.path(), tools_));
      result_.everybody.push_back(by);
    } else {
      add_unclaimed(name);  // or a pipe or a device, which no platform exports
    }
  }

  static bool is_handed_in(const fs::directory_entry& entry) {
    return is_folder(entry) || (is_file(entry) && is_packed(entry.path().filename()));
  }

  // The name of a folder or an archive that no platform has named.
  static std::string learner_of(const fs::directory_entry& entry) {
    const std::string name = entry.path().filename();
    return is_file(entry) && is_packed(name) ? without_ending(name) : name;
  }

  void add_unclaimed(const std::string& name) {
    result_.unclaimed.push_back(name);
    result_.work_is_unclaimed = result_.work_is_unclaimed || is_source(name) || is_packed(name) ||
                                !named_task(name, tools_.tasks).empty();
  }

  void add_prepared(const HandedIn& by) {
    result_.everybody.push_back(
        by.problem.empty() ? with(by, prepare_submission(by.name, by.folder, tools_)) : by);
  }

  void add_piece(const Piece& piece) {
    Pieces& pieces = pieces_[piece.label.key];
    HandedIn& by = pieces.by;
    by.name = piece.label.name;
    by.id = piece.label.id;
    by.late = by.late || piece.label.late;
    by.platform = piece.label.platform;
    if (by.problem.empty()) by.problem = fault_of(piece.path);
    pieces.all.push_back(piece);
  }

  void add_gradescope(const fs::path& list, const std::vector<fs::directory_entry>& entries) {
    std::map<std::string, Submitters> listed = read_gradescope_list(list);
    std::map<std::string, fs::path> folders;
    for (const fs::directory_entry& entry : entries) {
      if (!is_folder(entry)) continue;
      folders[entry.path().filename()] = entry.path();
      listed.try_emplace(entry.path().filename());
    }
    start(listed.size());
    for (const auto& [folder, who] : listed) {
      HandedIn by;
      by.name = who.names.empty() ? folder : who.names;
      by.id = who.ids;
      by.handed_in = who.handed_in;
      by.platform = Platform::gradescope;
      const auto place = folders.find(folder);
      if (place == folders.end()) {
        by.problem = "the list of submissions names it, and the export has no folder for it";
      } else {
        by.folder = place->second;
        by.problem = fault_of(place->second);
      }
      add_prepared(by);
      count();
    }
  }

  // A submission whose name begins with a dot belongs to nobody, unless it is renamed.
  void name_hidden(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename();
      if (!base::is_hidden(name) || entry.is_symlink()) continue;
      const bool is_handed_in =
          is_folder(entry) ? is_submission(entry.path(), tools_.tasks) : is_archive(name);
      if (is_handed_in) add_unclaimed(name);
      result_.work_is_unclaimed = result_.work_is_unclaimed || is_handed_in;
    }
    std::sort(result_.unclaimed.begin(), result_.unclaimed.end());
  }

  fs::path next_folder() {
    fs::create_directories(work_);
    return work_ / std::to_string(++folders_);
  }

  fs::path work_;
  IntakeTools tools_;
  const std::vector<NameForm>& table_;
  const Progress& progress_;
  std::size_t done_ = 0, all_ = 0;
  int folders_ = 0;
  Labels labels_;
  std::map<std::string, std::string> faults_;  // by path
  std::map<std::string, int> claims_;  // how many folders and archives have a learner's name
  std::map<std::string, Pieces> pieces_;
  HandedInByAll result_;
};

}  // namespace

HandedInByAll handed_in(const std::string& input, const std::string& work,
                        const std::vector<TaskFile>& tasks, const Readers& readers,
                        const std::vector<NameForm>& table, const Progress& progress,
                        Attempt attempt) {
  return Intake(work, tasks, readers, table, progress, attempt).run(input);
}

}  // namespace grader::intake
