#pragma once

#include "grader/base/files.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace grader::intake {

// A task, whose file is <part>/<slug>.cpp.
struct TaskFile {
  std::string part, slug;
};

// The task file that this file is meant to be; also for "Hit_Box.CPP", "hit_box-1.cpp", "hit_box
// (2).cpp", "hit_box.cpp.txt". Empty: not a task file. `is_exact`: the judge would read it.
struct Meant {
  std::string slug;
  bool is_exact = false;
  explicit operator bool() const { return !slug.empty(); }
};
Meant meant_task(const std::string& name, const std::vector<TaskFile>& tasks);

// The task whose name is in a file's name, which need not be a task file: "hit_box_final.cpp",
// "hit_box.cc"; else empty.
std::string named_task(const std::string& name, const std::vector<TaskFile>& tasks);

// The task files of a folder.
struct Tree {
  // The folder in which the judge finds all task files; empty: they have to be copied.
  std::filesystem::path root;
  std::map<std::string, std::filesystem::path> files;  // per task: the file that counts
  std::string problem;             // why the files are ambiguous, in one sentence; else empty
  std::vector<std::string> notes;  // which file counts of several that differ
  std::vector<std::filesystem::path> archives, others;  // files that belong to no task
};

// Looks for task files at any depth. It skips hidden files, links to folders, and all of a whole
// project except `student`. Throws std::filesystem::filesystem_error if a folder cannot be read.
Tree look_inside(const std::filesystem::path& folder, const std::vector<TaskFile>& tasks);

// Sentences about other files that somebody may have meant to count. `files` are those that count.
std::vector<std::string> notes_on_others(const Tree& tree, const std::filesystem::path& folder,
                                         const std::map<std::string, std::filesystem::path>& files,
                                         const std::vector<TaskFile>& tasks);

// Returns whether the folder is one submission, by the files and folders at its top. A folder that has only one folder is entered first.
bool is_submission(const std::filesystem::path& folder, const std::vector<TaskFile>& tasks);

// Returns whether several of its folders and archives are submissions. Then it is not one
// submission, even with a task file or a repository at the top.
bool holds_several(const std::filesystem::path& folder, const std::vector<TaskFile>& tasks);

// The first task of which there is a file and a copy ("hit_box (1).cpp", "Copy of hit_box.cpp") here:
// where names of learners are lost, they are files of several learners. Empty: none.
std::string numbered_twice(const std::filesystem::path& folder, const std::vector<TaskFile>& tasks);

// The text of a file that is not a link.
base::Submitted read_file(const std::filesystem::path& file);

// Returns whether it is a task that is not written: it calls todo().
bool is_stub(const std::filesystem::path& file);

// Returns whether both can be read, and have the same text.
bool are_equal(const std::filesystem::path& a, const std::filesystem::path& b);

// Returns whether a path is the folder, or is inside it.
bool lies_in(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace grader::intake
