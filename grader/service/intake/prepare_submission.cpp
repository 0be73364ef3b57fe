#include "grader/service/intake/prepare_submission.h"

#include "grader/base/files.h"
#include "grader/service/intake/file_name.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <array>
#include <set>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::intake {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxInside = 3;  // archives in archives

// Returns whether the machine is at fault, not the file.
bool is_of_machine(const std::error_code& code) {
  constexpr std::array kOfMachine{std::errc::no_space_on_device,
                                  std::errc::io_error,
                                  std::errc::too_many_files_open,
                                  std::errc::too_many_files_open_in_system,
                                  std::errc::not_enough_memory,
                                  std::errc::read_only_file_system,
                                  std::errc::resource_unavailable_try_again};
  return code.value() == EDQUOT || std::any_of(kOfMachine.begin(), kOfMachine.end(),
                                               [&](std::errc each) { return code == each; });
}

std::string nothing_found(const Tree& tree, const std::vector<TaskFile>& tasks) {
  const std::string none =
      fmt::format("it holds none of the files that are to be handed in ({}.cpp and so on)",
                  tasks.empty() ? "TASK" : tasks[0].slug);
  if (tree.others.empty()) return none + ": it is empty";
  const auto packed = std::find_if(tree.others.begin(), tree.others.end(),
                                   [](const fs::path& each) { return is_packed(each); });
  if (packed != tree.others.end()) {
    return fmt::format("it holds only '{}', which cannot be unpacked here; hand in a zip",
                       as_file_name(packed->filename()));
  }
  const std::size_t more = tree.others.size() - 1;
  return fmt::format("{}, only '{}'{}{}", none, as_file_name(tree.others[0].filename()),
                     fs::is_symlink(tree.others[0]) ? " (a link)" : "",
                     more == 0 ? "" : fmt::format(" and {} more", more));
}

// The task files of a submission, not yet copied.
struct Work {
  fs::path folder;                        // in which the judge finds them all; empty: in none
  std::map<std::string, fs::path> files;  // by task
  std::string problem;
  bool nothing = false;
  std::vector<std::string> notes{};
  bool is_flat = false;                  // without folders for the parts, as files of platforms are
  std::optional<door::Course> course{};  // of a clone: the folder has what was made of it
};

// Puts a file of the same kind in the place of one that cannot be used: the judge rejects it for the same
// reason, so that it costs its own task only. `top` is the folder of all copies.
void put_unusable(const fs::path& from, const fs::path& copy, const fs::path& top) {
  const fs::file_status is = fs::symlink_status(from);
  if (fs::is_regular_file(is) && fs::file_size(from) > base::kMaxFile) {
    pt::write_file(copy, "");
    fs::resize_file(copy, base::kMaxFile + 1);
  } else if (fs::is_regular_file(is) && fs::hard_link_count(from) > 1) {
    pt::write_file(copy, "");
    fs::create_directories(top / "student");  // a place that the judge reads later, if at all
    fs::create_hard_link(copy, top / "student" / copy.filename());
  } else if (fs::is_regular_file(is) || fs::is_symlink(is) || !fs::exists(is)) {
    fs::create_symlink("refused", copy);
  } else {
    fs::create_directory(copy);
  }
}

// Copies the task files to names that the judge reads.
Prepared copy_tasks(const Work& work, const IntakeTools& tools) {
  const fs::path to = tools.next_folder();
  std::vector<std::string> refused;
  bool is_empty = true;
  for (const TaskFile& task : tools.tasks) {
    const auto file = work.files.find(task.slug);
    if (file == work.files.end()) continue;
    const fs::path& from = file->second;
    const base::Submitted read = read_file(from);
    const fs::path folder = work.is_flat ? to : to / task.part;
    fs::create_directories(folder);
    const fs::path copy = folder / (task.slug + ".cpp");
    if (!read.present || !read.rejected.empty()) {
      refused.push_back(fmt::format("'{}': {}", as_file_name(from.filename()),
                                    read.present ? read.rejected : "it cannot be read"));
      put_unusable(from, copy, to);
      continue;
    }
    pt::write_file(copy, read.text);
    is_empty = false;
  }
  if (is_empty && !refused.empty()) return {to, refused[0]};
  return {to, "", fmt::format("{}", fmt::join(refused, "; "))};
}

std::string sentence(const std::vector<std::string>& notes) {
  constexpr std::size_t kMaxNotes = 3;
  const auto first = notes.begin() + static_cast<std::ptrdiff_t>(std::min(notes.size(), kMaxNotes));
  const std::string more =
      notes.size() > kMaxNotes ? fmt::format("; and {} more", notes.size() - kMaxNotes) : "";
  return fmt::format("{}{}", fmt::join(notes.begin(), first, "; "), more);
}

Prepared prepared(const Work& work, const IntakeTools& tools) {
  if (!work.problem.empty()) return {work.folder, work.problem, "", work.nothing, work.course};
  Prepared result = work.folder.empty() ? copy_tasks(work, tools) : Prepared{work.folder, ""};
  result.course = work.course;
  std::vector<std::string> notes = work.notes;
  if (!result.note.empty()) notes.insert(notes.begin(), result.note);
  result.note = sentence(notes);
  return result;
}

Work settle(const fs::path& folder, const IntakeTools& tools, int depth);

Work unpack_at(const fs::path& archive, const IntakeTools& tools, int depth) {
  if (depth > kMaxInside)
    return {"", {}, fmt::format("it has archives in archives, more than {} deep", kMaxInside)};
  if (!is_archive(archive.filename())) {
    return {"",
            {},
            fmt::format("'{}' cannot be unpacked here; hand in a zip",
                        as_file_name(archive.filename()))};
  }
  const fs::path folder = tools.next_folder();
  const std::string problem = tools.readers.unpack(archive, folder, Extent::one);
  if (problem.empty()) return settle(folder, tools, depth + 1);
  fs::remove_all(folder);  // it may be incomplete
  return {folder, {}, problem};
}

// Adds the files of an archive that lies beside the task files. These count if both have a file,
// unless only that of the archive is written.
void add_archive(Work& work, const fs::path& archive, const IntakeTools& tools, int depth) {
  const Work inner = unpack_at(archive, tools, depth);
  const std::string name = as_file_name(archive.filename());
  if (inner.nothing) return;
  if (inner.course)
    return work.notes.push_back(
        fmt::format("the clone in '{}' beside the files does not count", name));
  if (!inner.problem.empty())
    return work.notes.push_back(
        fmt::format("'{}' beside the files does not count: {}", name, inner.problem));
  std::vector<std::string> added, other;
  for (const auto& [slug, file] : inner.files) {
    const auto [entry, is_new] = work.files.try_emplace(slug, file);
    const bool is_written = !is_new && is_stub(entry->second) && !is_stub(file);
    if (is_written) entry->second = file;
    if (is_new || is_written) added.push_back(slug);
    if (!is_new && !are_equal(file, entry->second)) other.push_back(slug);
  }
  if (!added.empty()) {
    work.folder.clear();
    work.notes.push_back(fmt::format("{} from '{}' beside the other files count{}",
                                     fmt::join(added, ", "), name, added.size() == 1 ? "s" : ""));
  }
  if (!other.empty())
    work.notes.push_back(fmt::format("{} in '{}' do{} not count, as the file beside it does",
                                     fmt::join(other, ", "), name, other.size() == 1 ? "es" : ""));
}

// The task files that are made of a clone.
Work flattened(const fs::path& folder, const std::vector<fs::path>& clones,
               const IntakeTools& tools) {
  if (clones.size() > 1) {
    return {
        folder,
        {},
        fmt::format("it has {} clones of the course's skeleton, '{}' and '{}' among them; keep one",
                    clones.size(), as_file_name(clones[0].filename()),
                    as_file_name(clones[1].filename()))};
  }
  const door::Clone clone = door::read_clone(clones[0]);
  Work work{tools.next_folder(), {}, clone.problem};
  work.course = door::course_of(clone);
  if (work.problem.empty())
    work.problem =
        tools.readers.flatten((clones[0] / "").parent_path().filename(), clone, work.folder);
  return work;
}

// The clones in the folder, if no task file lies outside of them.
std::vector<fs::path> clones_that_count(const fs::path& folder, const Tree& tree,
                                        const IntakeTools& tools) {
  if (!tools.readers.flatten) return {};
  const std::vector<fs::path> clones = door::clones_in(folder);
  const bool all_inside = std::ranges::all_of(tree.files, [&](const auto& file) {
    return std::ranges::any_of(clones,
                               [&](const fs::path& each) { return lies_in(file.second, each); });
  });
  return all_inside ? clones : std::vector<fs::path>();
}

Work settle(const fs::path& folder, const IntakeTools& tools, int depth) {
  const Tree tree = look_inside(folder, tools.tasks);
  const std::vector<fs::path> clones = clones_that_count(folder, tree, tools);
  if (!clones.empty()) return flattened(folder, clones, tools);
  const std::vector<fs::path>& archives = tree.archives;
  Work work{tree.root, tree.files, tree.problem, false, tree.notes};
  const std::string several =
      archives.size() < 2
          ? ""
          : fmt::format("it holds {} archives, '{}' and '{}' among them", archives.size(),
                        as_file_name(archives[0].filename()), as_file_name(archives[1].filename()));
  if (!work.problem.empty()) {
    work.folder = folder;
  } else if (work.files.empty() && archives.empty()) {
    work = {folder, {}, nothing_found(tree, tools.tasks), true, {}};
  } else if (work.files.empty() && archives.size() == 1) {
    work = unpack_at(archives[0], tools, depth);
  } else if (work.files.empty()) {
    work = {folder, {}, several + "; keep one", false, {}};
  } else if (archives.size() == 1) {
    add_archive(work, archives[0], tools, depth);
  } else if (archives.size() > 1) {
    work.notes.push_back(several + ", of which none is read, as there are files beside them");
  }
  const std::vector<std::string> others = notes_on_others(tree, folder, work.files, tools.tasks);
  work.notes.insert(work.notes.end(), others.begin(), others.end());
  return work;
}

// The files of a later attempt replace those of the earlier ones.
Work settle_attempts(const std::vector<fs::path>& folders, const IntakeTools& tools) {
  Work all;
  std::set<std::string> earlier;
  for (const fs::path& folder : folders) {
    const Work work = settle(folder, tools, 0);
    if (work.nothing && (all.course || !all.files.empty())) {
      all.notes.emplace_back("the last attempt holds no task file, so an earlier one counts");
      continue;
    }
    if (!work.problem.empty() || work.course || all.files.empty()) {
      all = work;
      continue;
    }
    for (const auto& [slug, file] : all.files) earlier.insert(slug);
    for (const auto& [slug, file] : work.files) {
      if (all.files.contains(slug) && is_stub(file) && !is_stub(all.files[slug])) continue;
      earlier.erase(slug);
      all.files[slug] = file;
    }
    all.folder.clear();
    all.is_flat = true;
    all.notes = work.notes;
    all.notes.insert(all.notes.begin(),
                     earlier.empty()
                         ? "of several attempts the last counts"
                         : fmt::format("of several attempts the last counts, but for "
                                       "{}, which it does not hold or which is not written there",
                                       fmt::join(earlier, ", ")));
  }
  return all;
}

}  // namespace

Prepared read_handed_in(const std::string& name, const fs::path& folder,
                        const std::function<Prepared()>& read) {
  try {
    return read();
  } catch (const fs::filesystem_error& error) {
    const std::string file = as_file_name(error.path1().filename());
    if (is_of_machine(error.code())) {
      throw pt::Error(fmt::format("'{}' cannot be taken in: {}: {}; run this again", name, file,
                                  error.code().message()));
    }
    return {folder, fmt::format("'{}' cannot be read: {}", file, error.code().message())};
  }
}

Prepared prepare_submission(const std::string& name, const fs::path& from,
                            const IntakeTools& tools) {
  return read_handed_in(name, from, [&] {
    return prepared(fs::is_directory(from) ? settle(from, tools, 0) : unpack_at(from, tools, 0),
                    tools);
  });
}

Prepared prepare_attempts(const std::string& name, const std::vector<fs::path>& folders,
                          const IntakeTools& tools) {
  return read_handed_in(name, folders.back(),
                        [&] { return prepared(settle_attempts(folders, tools), tools); });
}

}  // namespace grader::intake
