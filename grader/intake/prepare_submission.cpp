#include "grader/intake/prepare_submission.h"

#include "grader/base/descriptor.h"
#include "grader/base/files.h"
#include "grader/intake/file_name.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <array>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>

namespace grader::intake {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxInside = 3;  // archives in archives

// Returns whether the machine is at fault, and not the file.
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

// To the names under which the judge reads them.
void copy_tasks(HandedIn& by, const Tree& tree, const IntakeTools& tools) {
  by.folder = tools.next_folder();
  for (const TaskFile& task : tools.tasks) {
    const auto file = tree.files.find(task.slug);
    if (file == tree.files.end()) continue;
    const fs::path& from = file->second;
    const base::Descriptor folder(
        open(from.parent_path().c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    const base::Submitted read =
        base::read_plain_file(folder.number(), from.filename(), base::kMaxFile);
    if (!read.present || !read.rejected.empty()) {
      by.problem = fmt::format("'{}': {}", as_file_name(from.filename()),
                               read.present ? read.rejected : "it cannot be read");
      return;
    }
    fs::create_directories(fs::path(by.folder) / task.part);
    pt::write_file(fs::path(by.folder) / task.part / (task.slug + ".cpp"), read.text);
  }
}

void settle_at(HandedIn& by, const IntakeTools& tools, int depth);

void unpack_at(HandedIn& by, const fs::path& archive, const IntakeTools& tools, int depth) {
  if (depth > kMaxInside) {
    by.problem = fmt::format("it has archives in archives, more than {} deep", kMaxInside);
    return;
  }
  by.folder = tools.next_folder();
  by.problem = tools.unpack(archive, by.folder, Extent::one);
  if (by.problem.empty()) {
    settle_at(by, tools, depth + 1);
  } else {
    fs::remove_all(by.folder);  // half of it
  }
}

void settle_at(HandedIn& by, const IntakeTools& tools, int depth) {
  const Tree tree = look_inside(by.folder, tools.tasks);
  by.problem = tree.problem;
  if (!tree.problem.empty()) return;
  if (!tree.root.empty()) {
    by.folder = tree.root;
  } else if (!tree.files.empty()) {
    copy_tasks(by, tree, tools);
  } else if (tree.archives.size() == 1) {
    unpack_at(by, tree.archives[0], tools, depth);
  } else if (tree.archives.size() > 1) {
    by.problem = fmt::format("it holds {} archives, '{}' and '{}' among them; keep one",
                             tree.archives.size(), as_file_name(tree.archives[0].filename()),
                             as_file_name(tree.archives[1].filename()));
  } else if (is_bare_repository(base::submission_root(by.folder))) {
    by.problem =
        "it is a git repository without its files (a bare one); clone it, and hand in that";
  } else {
    by.problem = nothing_found(tree, tools.tasks);
  }
}

}  // namespace

void note_problem(HandedIn& by, const std::function<void()>& read) {
  try {
    read();
  } catch (const fs::filesystem_error& error) {
    const std::string file = as_file_name(error.path1().filename());
    if (is_of_machine(error.code())) {
      throw pt::Error(fmt::format("'{}' cannot be taken in: {}: {}; run this again", by.name, file,
                                  error.code().message()));
    }
    by.problem = fmt::format("'{}' cannot be read: {}", file, error.code().message());
  }
}

void prepare_submission(HandedIn& by, const IntakeTools& tools) {
  note_problem(by, [&] { settle_at(by, tools, 0); });
}

void prepare_archive(HandedIn& by, const fs::path& archive, const IntakeTools& tools) {
  note_problem(by, [&] { unpack_at(by, archive, tools, 0); });
}

}  // namespace grader::intake
