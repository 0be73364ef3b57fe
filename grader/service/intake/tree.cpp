#include "grader/service/intake/tree.h"

#include "grader/base/descriptor.h"
#include "grader/door/clone.h"
#include "grader/service/intake/file_name.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <system_error>
#include <tuple>

#include <fcntl.h>
#include <fmt/format.h>

namespace grader::intake {

namespace fs = std::filesystem;

namespace {

// A file that may be a task's.
struct Candidate {
  fs::path path;
  fs::path root;  // the folder in which its tree starts
  bool is_exact = false;
  int way = 0;  // how base::read_submitted would find it: 0 first; 4: not at all
};
using Candidates = std::map<std::string, std::vector<Candidate>>;  // by task

bool is_part(const std::string& name, const std::vector<TaskFile>& tasks) {
  return std::any_of(tasks.begin(), tasks.end(),
                     [&](const TaskFile& task) { return task.part == name; });
}

std::string without_marks(std::string text) {
  std::erase_if(text, [](char c) { return c == '_' || c == '-' || c == ' '; });
  return text;
}

// Nothing above `top`, the submission's folder, is the submission's.
Candidate candidate(const fs::path& path, const Meant& meant, const std::vector<TaskFile>& tasks,
                    const fs::path& top) {
  const auto task = std::find_if(tasks.begin(), tasks.end(),
                                 [&](const TaskFile& each) { return each.slug == meant.slug; });
  Candidate found{path, path.parent_path(), meant.is_exact, 2};
  const std::string folder = found.root.filename();
  if (found.root != top && is_part(folder, tasks)) {
    found.way = folder == task->part ? 0 : 4;
    found.root = found.root.parent_path();
  }
  if (found.root != top && found.root.filename() == "student") {
    found.way = std::min(found.way + 1, 4);
    found.root = found.root.parent_path();
  }
  return found;
}

// A clone or a copy of the project has more files with a task's name.
bool is_project(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "pt", error) && fs::is_directory(folder / "student", error);
}

void walk(const fs::path& folder, const fs::path& top, const std::vector<TaskFile>& tasks,
          Tree& tree, Candidates& candidates) {
  const bool of_project = is_project(folder);
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (base::is_hidden(name)) continue;
    if (entry.is_directory() && !entry.is_symlink()) {
      if (!of_project || name == "student") walk(entry.path(), top, tasks, tree, candidates);
    } else if (const Meant meant = meant_task(name, tasks)) {
      candidates[meant.slug].push_back(candidate(entry.path(), meant, tasks, top));
    } else if (is_archive(name) && entry.is_regular_file() && !entry.is_symlink()) {
      tree.archives.push_back(entry.path());
    } else {
      tree.others.push_back(entry.path());
    }
  }
}

// The file that counts among the candidates of a task: one that is written, then one with the exact
// name, then the outermost file, then the file that the judge would read first. Nothing if two that
// differ are left.
const Candidate* that_counts(std::vector<Candidate>& all) {
  const auto is_unwritten = [](const Candidate& each) { return is_stub(each.path); };
  if (all.size() > 1 && !std::all_of(all.begin(), all.end(), is_unwritten))
    std::erase_if(all, is_unwritten);
  const auto is_exact = [](const Candidate& each) { return each.is_exact; };
  if (std::any_of(all.begin(), all.end(), is_exact)) {
    std::erase_if(all, [&](const Candidate& each) { return !is_exact(each); });
  }
  std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(a.root, a.way, a.path) < std::tuple(b.root, b.way, b.path);
  });
  const Candidate& first = all[0];
  for (std::size_t i = 1; i < all.size(); ++i) {
    const bool beside = all[i].root == first.root && all[i].way == first.way;
    const bool is_question = beside || !lies_in(all[i].root, first.root);
    if (is_question && !are_equal(all[i].path, first.path)) return nullptr;
  }
  return &first;
}

// The path of a file in the submission, for messages.
std::string shown(const fs::path& file, const fs::path& folder) {
  std::string clean;
  for (const auto& part : file.lexically_relative(folder))
    clean += (clean.empty() ? "" : "/") + as_file_name(part);
  return clean;
}

std::string question(const fs::path& folder, const std::string& slug,
                     const std::vector<Candidate>& all) {
  if (all[0].path.parent_path() == all[1].path.parent_path()) {
    return fmt::format("'{}' and '{}' may both be {}.cpp; name one of them so",
                       as_file_name(all[0].path.filename()), as_file_name(all[1].path.filename()),
                       slug);
  }
  return fmt::format("it has {}.cpp in {} places, '{}' and '{}'; keep one", slug, all.size(),
                     shown(all[0].path, folder), shown(all[1].path, folder));
}

// Returns whether the judge would read these files in the tree's root, and no others.
bool reads_these(const Tree& tree, const std::vector<TaskFile>& tasks) {
  return tree.root.empty() || std::all_of(tasks.begin(), tasks.end(), [&](const TaskFile& task) {
           const base::Submitted judged = base::read_submitted(tree.root, task.part, task.slug);
           const auto file = tree.files.find(task.slug);
           if (file == tree.files.end()) return !judged.present;
           const base::Submitted counts = read_file(file->second);
           return judged.text == counts.text && judged.rejected == counts.rejected;
         });
}

}  // namespace

base::Submitted read_file(const fs::path& file) {
  const base::Descriptor folder(open(file.parent_path().c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  return base::read_plain_file(folder.number(), file.filename(), base::kMaxFile);
}

bool is_stub(const fs::path& file) {
  std::istringstream text(read_file(file).text);
  for (std::string line; std::getline(text, line);) {
    if (line.find("todo(") < line.find("//")) return true;
  }
  return false;
}

bool are_equal(const fs::path& a, const fs::path& b) {
  const base::Submitted one = read_file(a), two = read_file(b);
  const bool are_read = one.present && two.present && (one.rejected + two.rejected).empty();
  return are_read && one.text == two.text;
}

std::string numbered_twice(const fs::path& folder, const std::vector<TaskFile>& tasks) {
  std::set<std::string> found, numbered;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    const Meant meant = meant_task(name, tasks);
    const bool second = meant && !found.insert(meant.slug).second;
    const bool is_copy = name.find('(') != name.npos || lower_case(name).starts_with("copy of ");
    if (meant && is_copy) numbered.insert(meant.slug);
    if (second && numbered.contains(meant.slug)) return meant.slug;
  }
  return "";
}

bool lies_in(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

Meant meant_task(const std::string& name, const std::vector<TaskFile>& tasks) {
  static const std::regex nearly(
      R"((?:copy of |kopie von |copie de |copia de )*(.+?))"
      R"((?:[ _]?\(\d+\)|-\d+|[ _-]*(?:copy|kopie|copie|copia)|[ _-]+(?:final|last|latest|new|neu|fixed|done|v\d+))*)"
      R"(\.(?:cpp|cc|cxx|c\+\+)(?:\.txt)?)");
  const std::string small = lower_case(name);
  std::smatch found;
  if (name.size() > 255 || !std::regex_match(small, found, nearly)) return {};
  const std::string stem = without_marks(found[1]);
  for (const TaskFile& task : tasks) {
    if (without_marks(task.slug) == stem) return {task.slug, name == task.slug + ".cpp"};
  }
  return {};
}

std::string named_task(const std::string& name, const std::vector<TaskFile>& tasks) {
  std::string letters = without_marks(lower_case(name));
  std::erase_if(letters, [](unsigned char c) { return c < ' ' || c > '~'; });  // unseen
  const auto task = std::ranges::find_if(tasks, [&](const TaskFile& each) {
    return letters.find(without_marks(each.slug)) != letters.npos;
  });
  return task == tasks.end() ? "" : task->slug;
}

Tree look_inside(const fs::path& given, const std::vector<TaskFile>& tasks) {
  const fs::path folder = given.has_filename() ? given : given.parent_path();
  Tree tree;
  Candidates candidates;
  walk(folder, folder, tasks, tree, candidates);
  std::sort(tree.archives.begin(), tree.archives.end());
  std::sort(tree.others.begin(), tree.others.end());
  bool stays = true;
  for (auto& [slug, all] : candidates) {
    const std::vector<Candidate> before = all;
    const Candidate* counts = that_counts(all);
    if (counts == nullptr) {
      if (tree.problem.empty()) tree.problem = question(folder, slug, all);
      continue;
    }
    if (tree.files.empty()) tree.root = counts->root;
    stays = stays && counts->is_exact && counts->way < 4 && counts->root == tree.root;
    tree.files[slug] = counts->path;
    for (const Candidate& other : before) {
      if (other.path != counts->path && !are_equal(other.path, counts->path))
        tree.notes.push_back(fmt::format("'{}' counts, and not '{}', which differs",
                                         shown(counts->path, folder), shown(other.path, folder)));
    }
  }
  if (!stays || !reads_these(tree, tasks)) tree.root.clear();
  return tree;
}

std::vector<std::string> notes_on_others(const Tree& tree, const fs::path& folder,
                                         const std::map<std::string, fs::path>& files,
                                         const std::vector<TaskFile>& tasks) {
  std::vector<std::string> notes;
  for (const fs::path& other : tree.others) {
    const std::string name = other.filename(), slug = named_task(name, tasks);
    if (name.ends_with(".examples.cpp")) continue;  // examples of a task (./run examples)
    if (is_packed(name)) {
      notes.push_back(
          fmt::format("'{}' cannot be unpacked here, and does not count", shown(other, folder)));
    } else if (!slug.empty() && (is_source(name) || !files.contains(slug))) {
      notes.push_back(fmt::format("'{}' does not count, as it is not named {}.cpp",
                                  shown(other, folder), slug));
    }
  }
  return notes;
}

bool is_submission(const fs::path& folder, const std::vector<TaskFile>& tasks) {
  if (fs::exists(folder / ".git")) return true;
  const fs::path root = base::submission_root(folder);
  if (door::is_clone(root)) return true;
  for (const fs::path& top : {root, root / "student"}) {
    if (!fs::is_directory(top)) continue;
    for (const auto& entry : fs::directory_iterator(top)) {
      const std::string name = entry.path().filename();
      if (name == "student" || is_part(name, tasks) || meant_task(name, tasks)) return true;
    }
  }
  return false;
}

bool holds_several(const fs::path& folder, const std::vector<TaskFile>& tasks) {
  if (is_project(folder)) return false;
  int count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (base::is_hidden(name) || entry.is_symlink()) continue;
    if (entry.is_directory()) {
      count += name != "student" && !is_part(name, tasks) && is_submission(entry.path(), tasks);
    } else {
      count += is_archive(name);
    }
  }
  return count > 1;
}

}  // namespace grader::intake
