#include "writeup/code.h"

#include "grader/base/sha256.h"
#include "pt/error.h"
#include "pt/file.h"

#include <sstream>

namespace writeup {

namespace {

constexpr std::size_t kMaxObject = std::size_t{1} << 28;

}  // namespace

Code code_of_program(const std::filesystem::path& program) {
  Code code;
  code.command = {program.string()};
  std::map<std::string, std::string> contents;
  const std::filesystem::path build = program.parent_path().parent_path();
  std::istringstream list(pt::read_file(program.string() + ".objects", kMaxObject));
  // Each line has a name without spaces, one space, and a path.
  for (std::string name, path; list >> name && list.get() == ' ' && std::getline(list, path);) {
    contents[name] += grader::base::sha256(pt::read_file(build / path, kMaxObject));
  }
  if (contents.empty()) throw pt::Error(program.string() + ".objects is empty");
  for (const auto& [name, content] : contents) code.hash[name] = grader::base::sha256(content);
  return code;
}

std::string identity(const Code& code, const measure::Spec& spec) {
  std::string text = code.hash.at("framework");
  for (const std::string& task : measure::tasks_used(spec)) text += task + code.hash.at(task);
  return text;
}

std::string obstacle(const Code& code, const measure::Spec& spec) {
  for (const std::string& task : measure::tasks_used(spec)) {
    if (const auto found = code.unusable.find(task); found != code.unusable.end()) {
      return task + " " + found->second;
    }
  }
  return "";
}

}  // namespace writeup
