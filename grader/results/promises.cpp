#include "grader/results/promises.h"

#include <cctype>
#include <sstream>

namespace grader::results {

namespace {

constexpr std::string_view kHeading = "// Promises:";
constexpr std::string_view kItem = "//   - ";

// The items of the paragraph after the heading, each in one line, however it was wrapped.
std::vector<std::string> items(const std::string& header) {
  std::vector<std::string> found;
  std::istringstream lines(header);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(kHeading)) {
      inside = true;
    } else if (!line.starts_with("//") || line == "//") {
      inside = false;
    } else if (inside && line.starts_with(kItem)) {
      found.push_back(line.substr(kItem.size()));
    } else if (inside && !found.empty()) {
      const std::size_t start = line.find_first_not_of(' ', 2);
      if (start != std::string::npos) found.back() += " " + line.substr(start);
    }
  }
  return found;
}

}  // namespace

std::string property_name(const std::string& title) {
  std::string name;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\'') continue;
    if (std::isalnum(byte)) {
      name += static_cast<char>(std::tolower(byte));
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (name.ends_with('_')) name.pop_back();
  return name;
}

std::vector<Promise> promises_of(const std::string& header) {
  std::vector<Promise> promises;
  for (const std::string& item : items(header)) {
    const std::size_t colon = item.find(':');
    const std::string title = item.substr(0, colon);
    const std::string words = colon == std::string::npos ? "" : item.substr(colon + 2);
    const std::string name = property_name(title);
    promises.push_back({name, title, words, name.ends_with("_bonus")});
  }
  return promises;
}

}  // namespace grader::results
