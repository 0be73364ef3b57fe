#include "grader/service/build/compiler_output.h"

#include "grader/base/printable.h"
#include "grader/service/build/tool_run.h"

#include <algorithm>
#include <regex>
#include <sstream>

#include <fmt/format.h>

namespace grader::build {

namespace {

constexpr std::size_t kMaxErrorLines = 12;
constexpr std::size_t kMaxWarningLines = 40;

// The position in a line where an error of a compiler or linker begins; npos if there is none.
std::size_t error_in(const std::string& line) {
  std::size_t first = std::string::npos;
  for (const char* sign :
       {"error:", "Error:", "undefined reference to", "multiple definition of"}) {
    first = std::min(first, line.find(sign));
  }
  return first;
}

bool starts_error(const std::string& line) { return error_in(line) != std::string::npos; }

// Returns whether g++, clang, the assembler or a linker report in this line that no memory is left.
// A submission can print the same, but only its author is misled.
bool says_no_memory(const std::string& output) {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    for (const char* sign :
         {"virtual memory exhausted", "cc1plus: out of memory", "cc1plus: error: out of memory",
          "LLVM ERROR: out of memory", "as: out of memory",
          "terminate called after throwing an instance of 'std::bad_alloc'"}) {
      if (line.starts_with(sign)) return true;
    }
  }
  return false;
}

}  // namespace

std::string warnings_of(const std::string& output, const std::string& file) {
  std::istringstream lines(base::printable(output, process::kMaxOutput, true));
  std::string text;
  std::size_t count = 0;
  bool about_file = false;
  for (std::string line; std::getline(lines, line) && count < kMaxWarningLines;) {
    const bool explains = line.starts_with(' ');
    if (!explains) about_file = line.starts_with(file + ":");
    const bool starts =
        line.find(" warning: ") != std::string::npos || line.find(" note: ") != std::string::npos;
    if (!about_file || (!explains && !starts)) continue;
    text += line + '\n';
    ++count;
  }
  return text;
}

std::string first_error(const process::CommandResult& result, int seconds) {
  if (result.timed_out) return fmt::format("the compiler did not finish in {} s", seconds);
  if (!result.ok() && says_no_memory(result.output)) {
    return fmt::format(
        "the compiler wanted more than {} MiB of memory; are there huge arrays, or macros, "
        "templates or constant expressions that grow and grow?",
        kToolMemory >> 20);
  }
  std::istringstream lines(base::printable(result.output, process::kMaxOutput, true));
  std::string text;
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line) && count < kMaxErrorLines;) {
    if (starts_error(line) && count > 0) break;
    if (count > 0 || starts_error(line)) {
      text += line + '\n';
      ++count;
    }
  }
  return text.empty() ? "the compiler ended with " + process::describe_status(result.status) : text;
}

std::string in_project(const std::string& output, const std::string& tree, const std::string& own) {
  std::istringstream lines(output);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.find(own) == line.npos) text += line + '\n';
  }
  const auto replace = [&](const std::string& old, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(old, at)) != text.npos; at += by.size())
      text.replace(at, old.size(), by);
  };
  replace(tree + '/', "");
  replace("./pt/", "pt/");
  // The compiler draws the name of the file that it hands to the assembler.
  static const std::regex assembly(R"(\./cc\w{6}\.s\b)");
  return std::regex_replace(text, assembly, "assembly");
}

std::string without_parts(const std::string& output, const std::string& own) {
  std::istringstream lines(output);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    const bool is_own = line.find(own) != line.npos;
    if (is_own && !starts_error(line)) continue;
    text += (is_own ? line.substr(error_in(line)) : line) + '\n';
  }
  return text;
}

}  // namespace grader::build
