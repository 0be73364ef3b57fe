#include "grader/intake/handed_in.h"

#include "grader/base/files.h"
#include "grader/intake/unpack.h"
#include "pt/error.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

namespace grader::intake {

namespace fs = std::filesystem;

namespace {

constexpr int kMostInside = 3;          // archives in archives
constexpr std::size_t kMostName = 160;  // bytes

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
  std::string stem = fs::path(name).stem();
  return stem.ends_with(".tar") ? stem.substr(0, stem.size() - 4) : stem;
}

// The first bytes of a text, without half a character (UTF-8) at the end.
std::string beginning(const std::string& text, std::size_t most) {
  std::size_t end = std::min(most, text.size());
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
    --end;
  return text.substr(0, end);
}

// A file's name for a folder of our own, whatever a platform allows in a name. Of the names of a large
// group the beginning: a file's name has 255 bytes at most, and reports have endings.
std::string as_file_name(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return c == '/' || c < 0x20 || c == 0x7f; }, '_');
  name = beginning(name, kMostName);
  return name.empty() || name[0] == '.' ? "_" + name : name;
}

// All archives and all source files in a folder, however deep. Links are not followed.
struct Inside {
  std::vector<fs::path> archives, sources;
};
Inside look_inside(const fs::path& folder) {
  Inside inside;
  constexpr auto kSkip = fs::directory_options::skip_permission_denied;
  for (auto at = fs::recursive_directory_iterator(folder, kSkip);
       at != fs::recursive_directory_iterator(); ++at) {
    const std::string name = at->path().filename();
    if (base::is_hidden(name)) {
      if (is_folder(*at)) at.disable_recursion_pending();
    } else if (is_file(*at) && is_archive(name)) {
      inside.archives.push_back(at->path());
    } else if (name.ends_with(".cpp")) {
      inside.sources.push_back(at->path());
    }
  }
  std::sort(inside.archives.begin(), inside.archives.end());
  return inside;
}

class Intake {
 public:
  Intake(fs::path work, const Unpack& unpack) : work_(std::move(work)), unpack_(unpack) {
    fs::remove_all(work_);
  }

  std::vector<HandedIn> run(const fs::path& input) {
    fs::path folder = input;
    if (!fs::is_directory(input)) {
      folder = work_ / "all";
      fs::create_directories(work_);
      if (const std::string problem = unpack_(input, folder); !problem.empty()) {
        throw pt::Error(problem);
      }
    }
    folder = class_folder(folder);
    const std::vector<fs::directory_entry> entries = entries_of(folder);
    if (fs::exists(folder / kGradescopeList)) {
      add_gradescope(folder / kGradescopeList, entries);
    } else {
      for (const fs::directory_entry& entry : entries) add(entry);
      for (auto& [key, files] : canvas_) add_canvas(files);
    }
    if (all_.empty()) {
      throw pt::Error(input.string() +
                      " has no submissions in it: there must be a folder or an archive for each");
    }
    make_names_differ();
    return std::move(all_);
  }

 private:
  struct CanvasFile {
    fs::path path;
    std::string name;  // as it was handed in, without the number of the resubmission
    int number = 0;
  };
  struct CanvasFiles {
    HandedIn by;
    std::vector<CanvasFile> files;
  };

  // An export of Gradescope has one folder around everything.
  static fs::path class_folder(const fs::path& folder) {
    const std::vector<fs::directory_entry> entries = entries_of(folder);
    if (entries.size() != 1 || !is_folder(entries[0])) return folder;
    const fs::path& inner = entries[0].path();
    return fs::exists(inner / kGradescopeList) ? inner : folder;
  }

  void add(const fs::directory_entry& entry) {
    static const std::regex canvas(R"((.+?)_(LATE_)?(\d+)_(\d+)_(.+))");
    static const std::regex moodle(R"((.+)_(\d+)_assignsubmission_file_?)");
    const std::string name = entry.path().filename();
    std::smatch found;
    if (entry.is_symlink()) {
      HandedIn by;
      by.name = name;
      by.problem = "it is a link; copy what it points to";
      all_.push_back(by);
    } else if (is_folder(entry)) {
      HandedIn by;
      by.folder = entry.path();
      by.name = name;
      by.feedback = name + ".html";
      if (std::regex_match(name, found, moodle)) {
        by.name = found[1];
        by.id = found[2];
        by.platform = Platform::moodle;
        by.feedback = name + "/report.html";
      }
      add_folder(by);
    } else if (!is_file(entry)) {
      return;  // a pipe, a device: no platform exports one
    } else if (std::regex_match(name, found, canvas)) {
      CanvasFiles& files = canvas_[std::string(found[1]) + '_' + std::string(found[3])];
      files.by.name = found[1];
      files.by.id = found[3];
      files.by.late = files.by.late || found[2].matched;
      files.by.platform = Platform::canvas;
      // Canvas knows files by what stands before the name that the learner gave them.
      files.by.feedback = name.substr(0, name.size() - found[5].length()) + "report.html";
      files.files.push_back(canvas_file(entry.path(), found[5]));
    } else if (is_archive(name)) {
      HandedIn by;
      by.name = without_ending(name);
      by.feedback = by.name + ".html";
      unpack_into(by, entry.path(), 0);
      all_.push_back(by);
    }
  }

  static CanvasFile canvas_file(const fs::path& path, const std::string& name) {
    static const std::regex numbered(R"((.+)-(\d{1,6})(\.[A-Za-z.0-9]+))");
    std::smatch found;
    if (!std::regex_match(name, found, numbered)) return {path, name, 0};
    return {path, std::string(found[1]) + std::string(found[3]), std::stoi(found[2])};
  }

  void add_canvas(CanvasFiles& files) {
    std::map<std::string, const CanvasFile*> last;
    for (const CanvasFile& file : files.files) {
      const CanvasFile*& newest = last[file.name];
      if (newest == nullptr || file.number > newest->number) newest = &file;
    }
    files.by.folder = next_folder();
    fs::create_directories(files.by.folder);
    for (const auto& [name, file] : last) {
      fs::copy_file(file->path, fs::path(files.by.folder) / as_file_name(name),
                    fs::copy_options::skip_existing);
    }
    add_folder(files.by);
  }

  void add_gradescope(const fs::path& list, const std::vector<fs::directory_entry>& entries) {
    try {
      add_listed(YAML::LoadFile(list), entries);
    } catch (const YAML::Exception& error) {
      throw pt::Error(fmt::format("{}:{}: {}; export the submissions again", list.string(),
                                  error.mark.line + 1, error.msg));
    }
  }

  void add_listed(const YAML::Node& listed, const std::vector<fs::directory_entry>& entries) {
    for (const fs::directory_entry& entry : entries) {
      if (!is_folder(entry)) continue;
      const std::string folder = entry.path().filename();
      HandedIn by;
      by.name = folder;
      by.folder = entry.path();
      by.platform = Platform::gradescope;
      std::vector<std::string> names, ids;
      for (const auto& who : listed[folder][":submitters"]) {
        names.push_back(who[":name"].as<std::string>(""));
        ids.push_back(who[":sid"].as<std::string>(""));
      }
      if (!names.empty()) by.name = fmt::format("{}", fmt::join(names, ", "));
      by.id = fmt::format("{}", fmt::join(ids, ", "));
      add_folder(by);
    }
  }

  // A folder that holds no source file and one archive is what is in that archive.
  void add_folder(HandedIn by) {
    if (const std::optional<fs::path> archive = only_archive(by)) unpack_into(by, *archive, 0);
    all_.push_back(by);
  }

  static std::optional<fs::path> only_archive(HandedIn& by) {
    const Inside inside = look_inside(by.folder);
    if (!inside.sources.empty() || inside.archives.empty()) return std::nullopt;
    if (inside.archives.size() == 1) return inside.archives[0];
    by.problem = fmt::format("it holds {} archives, '{}' and '{}' among them; keep one",
                             inside.archives.size(), inside.archives[0].filename().string(),
                             inside.archives[1].filename().string());
    return std::nullopt;
  }

  void unpack_into(HandedIn& by, const fs::path& archive, int depth) {
    by.folder = next_folder();
    by.problem = unpack_(archive, by.folder);
    if (!by.problem.empty()) {
      fs::remove_all(by.folder);  // half of it
      return;
    }
    const std::optional<fs::path> inner = only_archive(by);
    if (!inner) return;
    if (depth < kMostInside) {
      unpack_into(by, *inner, depth + 1);
    } else {
      by.problem = fmt::format("it has archives in archives, more than {} deep", kMostInside);
    }
  }

  fs::path next_folder() {
    fs::create_directories(work_);
    return work_ / std::to_string(++folders_);
  }

  // Reports are named by them.
  void make_names_differ() {
    for (HandedIn& each : all_) each.name = as_file_name(each.name);
    std::map<std::string, int> count;
    for (const HandedIn& each : all_) ++count[each.name];
    std::set<std::string> used{"class"};  // class.html is the page of all
    for (HandedIn& each : all_) {
      if (count[each.name] > 1 && !each.id.empty())
        each.name += " (" + as_file_name(beginning(each.id, 30)) + ")";
      std::string name = each.name;
      for (int i = 2; !used.insert(name).second; ++i) name = fmt::format("{} ({})", each.name, i);
      each.name = name;
    }
    std::sort(all_.begin(), all_.end(),
              [](const HandedIn& a, const HandedIn& b) { return a.name < b.name; });
  }

  fs::path work_;
  const Unpack& unpack_;
  int folders_ = 0;
  std::map<std::string, CanvasFiles> canvas_;
  std::vector<HandedIn> all_;
};

}  // namespace

std::vector<HandedIn> handed_in(const std::string& input, const std::string& work,
                                const Unpack& unpack) {
  return Intake(work, unpack).run(input);
}

}  // namespace grader::intake
