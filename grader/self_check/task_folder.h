#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader::self_check {

// The names of the properties that a contract promises (grader/results/promises.h).
std::vector<std::string> promises_in(const std::filesystem::path& contract);

// A solution that is kept: a mistake or a relative of one as the build makes it (cmake/mistakes.cmake),
// or a file of grader/tasks/<slug>/right or noisy.
struct KeptSolution {
  std::string slug;
  std::string kind;  // "wrong", "relative", "right" or "noisy"
  std::string name;
  std::filesystem::path file;
};

// Those of a task and kind, in alphabetical order. `root` is the folder of the project.
std::vector<KeptSolution> kept_solutions(const std::filesystem::path& root, const std::string& slug,
                                         const std::string& kind);

// The one of this name. Throws pt::Error if there is none.
KeptSolution kept_solution(const std::filesystem::path& root, const std::string& slug,
                           const std::string& kind, const std::string& name);

// The text behind "// breaks: " or "// right: " in the first line of a wrong or right solution;
// empty if there is none.
std::string first_line(const std::filesystem::path& file, const std::string& label);

}  // namespace grader::self_check
