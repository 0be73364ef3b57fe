#include "grader/self_check/task_folder.h"

#include <algorithm>
#include <cctype>
#include <fstream>

namespace grader {

namespace {

namespace fs = std::filesystem;

std::string identifier(const std::string& words) {
  std::string name;
  for (const char c : words) {
    if (std::isalnum(static_cast<unsigned char>(c))) name += c;
    if (c == ' ' || c == '-') name += '_';
  }
  return name;
}

}  // namespace

std::vector<std::string> promises_in(const fs::path& contract) {
  const std::string item = "//   - ";
  std::vector<std::string> names;
  std::ifstream in(contract);
  bool listed = false;
  for (std::string line; std::getline(in, line);) {
    if (line == "// Promises:") listed = true;
    if (!listed || !line.starts_with(item)) continue;
    names.push_back(identifier(line.substr(item.size(), line.find(':') - item.size())));
  }
  return names;
}

std::string first_line(const fs::path& file, const std::string& label) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line.starts_with(label) ? line.substr(label.size()) : "";
}

std::vector<fs::path> sources_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".cpp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace grader
