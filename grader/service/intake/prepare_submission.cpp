#include "grader/service/intake/prepare_submission.h"

#include "grader/base/descriptor.h"
#include "grader/base/files.h"
#include "grader/service/intake/file_name.h"
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

// Copies the task files to the names that the judge reads.
Prepared copy_tasks(const Tree& tree, const IntakeTools& tools) {
  const fs::path to = tools.next_folder();
  for (const TaskFile& task : tools.tasks) {
    const auto file = tree.files.find(task.slug);
    if (file == tree.files.end()) continue;
    const fs::path& from = file->second;
    const base::Descriptor folder(
        open(from.parent_path().c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    const base::Submitted read =
        base::read_plain_file(folder.number(), from.filename(), base::kMaxFile);
    if (!read.present || !read.rejected.empty()) {
      return {to, fmt::format("'{}': {}", as_file_name(from.filename()),
                              read.present ? read.rejected : "it cannot be read")};
    }
    fs::create_directories(to / task.part);
    pt::write_file(to / task.part / (task.slug + ".cpp"), read.text);
  }
  return {to, ""};
}

Prepared settle_at(const fs::path& folder, const IntakeTools& tools, int depth);

Prepared unpack_at(const fs::path& archive, const IntakeTools& tools, int depth) {
  const fs::path folder = tools.next_folder();
  const std::string problem = tools.unpack(archive, folder, Extent::one);
  if (problem.empty()) return settle_at(folder, tools, depth + 1);
  fs::remove_all(folder);  // it may be incomplete
  return {folder, problem};
}

// Prepares a folder without a task file, which may contain one archive.
Prepared settle_archive(const fs::path& folder, const Tree& tree, const IntakeTools& tools,
                        int depth) {
  if (tree.archives.size() > 1) {
    return {folder, fmt::format("it holds {} archives, '{}' and '{}' among them; keep one",
                                tree.archives.size(), as_file_name(tree.archives[0].filename()),
                                as_file_name(tree.archives[1].filename()))};
  }
  if (depth > kMaxInside) {
    return {folder, fmt::format("it has archives in archives, more than {} deep", kMaxInside)};
  }
  return unpack_at(tree.archives[0], tools, depth);
}

Prepared settle_at(const fs::path& folder, const IntakeTools& tools, int depth) {
  const Tree tree = look_inside(folder, tools.tasks);
  if (!tree.problem.empty()) return {folder, tree.problem};
  if (!tree.root.empty()) return {tree.root, ""};
  if (!tree.files.empty()) return copy_tasks(tree, tools);
  if (!tree.archives.empty()) return settle_archive(folder, tree, tools, depth);
  return {folder, nothing_found(tree, tools.tasks)};
}

}  // namespace

HandedIn with(HandedIn by, const Prepared& prepared) {
  by.folder = prepared.folder;
  by.problem = prepared.problem;
  return by;
}

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

Prepared prepare_submission(const std::string& name, const fs::path& folder,
                            const IntakeTools& tools) {
  return read_handed_in(name, folder, [&] { return settle_at(folder, tools, 0); });
}

Prepared prepare_archive(const std::string& name, const fs::path& archive,
                         const IntakeTools& tools) {
  return read_handed_in(name, "", [&] { return unpack_at(archive, tools, 0); });
}

}  // namespace grader::intake
