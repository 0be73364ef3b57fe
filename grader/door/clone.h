#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

// Work in the skeleton of the course from which the tasks come (Berkeley CS184): a clone of the learner's repository.

namespace grader::door {

// A file of a clone: its text, or the reason why it is not read, in one sentence.
struct Source {
  std::string text;
  std::string refused{};
};

// The source files of a clone, by their paths in it: "src/scene/bvh.cpp".
struct Clone {
  std::map<std::string, Source> files;
  std::string problem{};  // why the clone cannot be read as a whole, in one sentence; else empty

  const Source* find(const std::string& path) const;
};

// Returns whether a file of this name is read.
bool is_read(const std::string& name);

// Returns whether the folder has the layout of the course, of 2019 or of a later year.
bool is_clone(const std::filesystem::path& folder);

// The clones in a folder: this folder alone if it is one, else those a few folders below it. Throws
// std::filesystem::filesystem_error if a folder cannot be read.
std::vector<std::filesystem::path> clones_in(const std::filesystem::path& folder);

// The paths of the files that read_clone() reads, as they are now; a folder that cannot be read is left out.
std::vector<std::string> paths_in(const std::filesystem::path& folder);

// Reads src/ and CGL/. A link, hard or soft, anything but a regular file, and a large file are
// refused; no link to a folder is followed, so nothing outside of the clone is read. There are
// bounds for number, size and depth. Throws std::filesystem::filesystem_error if a folder cannot be
// read.
Clone read_clone(const std::filesystem::path& folder);

// A clone as one text, and back. Throws pt::Error if it is not such a text.
std::string pack(const Clone& clone);
Clone unpack(const std::string& text);

// The years whose skeletons a clone is like. From 2020 on, its scene is in src/scene; since 2022,
// colours are vectors.
enum class Generation { of_2019 = 1, of_2020 = 2, of_2022 = 3 };

struct Course {
  Generation generation = Generation::of_2022;
  bool accumulates = false;  // it has the flag isAccumBounces, as since 2023

  bool operator==(const Course&) const = default;
};
Course course_of(const Clone& clone);

// "2019", "2020" or "2022": the first year.
const char* first_year(Generation generation);

// The first year of a course, which is 2023 with the flag; and back: nothing for another text.
std::string year_of(const Course& course);
std::optional<Course> course_since(const std::string& year);

}  // namespace grader::door
