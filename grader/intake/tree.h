#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace grader::intake {

// A task, whose file is <part>/<slug>.cpp.
struct TaskFile {
  std::string part, slug;
};

// The name of the task's file that a file is meant to be: also "Hit_Box.CPP", "hit_box-1.cpp",
// "hit_box (2).cpp", "hit_box.cpp.txt". Empty: of none. `is_exact`: the judge would read it.
struct Meant {
  std::string slug;
  bool is_exact = false;
  explicit operator bool() const { return !slug.empty(); }
};
Meant meant_task(const std::string& name, const std::vector<TaskFile>& tasks);

// The task files of a folder.
struct Tree {
  // The folder in which the judge finds all task files; empty: there is none such, and they have to be copied.
  std::filesystem::path root;
  std::map<std::string, std::filesystem::path> files;  // by task: the file that counts
  std::string problem;  // the reason why that cannot be said, in one sentence; else empty
  std::vector<std::filesystem::path> archives, others;  // files that are of no task
};

// Looks for task files, however deep. Hidden files and links to folders are left out, and of a whole project all but
// `student`. Throws std::filesystem::filesystem_error where a folder cannot be read.
Tree look_inside(const std::filesystem::path& folder, const std::vector<TaskFile>& tasks);

// Returns whether it is one submission, by the files and folders on top of it (below folders that stand alone).
bool is_submission(const std::filesystem::path& folder, const std::vector<TaskFile>& tasks);

// Returns whether several of its folders and archives are submissions: then a task file or a repository on top does not make
// it one.
bool holds_several(const std::filesystem::path& folder, const std::vector<TaskFile>& tasks);

// Returns whether a path is the folder's, or begins with it.
bool lies_in(const std::filesystem::path& path, const std::filesystem::path& folder);

// Returns whether it is a git repository without its files.
bool is_bare_repository(const std::filesystem::path& folder);

}  // namespace grader::intake
