// The folders of the grader, and those that each may include. A folder uses those that stand before
// it in the list; so no two use each other, and who reads one from the bottom up needs no other.
#include "grader/base/files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

namespace grader::self_check {
namespace {

namespace fs = std::filesystem;

// From the bottom up. The same word is the folder, the namespace (of tasks: check) and, with grader_,
// the library.
const std::vector<std::string> kFolders{"base",  "process", "sandbox",  "results",   "check",
                                        "tasks", "wire",    "mistakes", "pictures",  "report",
                                        "judge", "intake",  "programs", "self_check"};

// Folders for which the order alone would allow too much, each with all that it may include.
const std::map<std::string, std::set<std::string>> kOnly{
    {"results", {"base"}},
    {"check", {"base", "process", "results"}},
    {"tasks", {"base", "results", "check"}},
    {"mistakes", {"base", "results", "check"}},
    {"intake", {"base"}},
    {"report", {"base", "results", "pictures"}}};

struct Source {
  fs::path path;
  std::string folder, text;
};

// Solutions of a task, right and wrong ones, and submissions that attack are not the grader's code.
bool is_ours(const fs::path& below) {
  const auto depth = std::distance(below.begin(), below.end());
  const std::string folder = *below.begin();
  if (folder == "tasks") return depth == 3;
  return folder != "self_check" || depth == 2;
}

std::vector<Source> sources() {
  std::vector<Source> all;
  const fs::path grader = FIRSTLIGHT_ROOT "/grader";
  for (const auto& entry : fs::recursive_directory_iterator(grader)) {
    const fs::path below = fs::relative(entry.path(), grader);
    const std::string folder = *below.begin();
    const std::string type = entry.path().extension();
    const bool code = type == ".cpp" || type == ".h";
    if (code && is_ours(below) && std::ranges::count(kFolders, folder) > 0) {
      all.push_back({below, folder, base::read_file(entry.path())});
    }
  }
  return all;
}

// The folders that a text includes headers of, with the line.
std::map<std::string, std::string> included(const std::string& text) {
  static const std::regex include(R"(^#include "grader/(\w+)/.*)");
  std::map<std::string, std::string> folders;
  std::istringstream lines(text);
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, found, include)) folders[found[1]] = line;
  }
  return folders;
}

bool may_include(const std::string& folder, const std::string& other) {
  if (folder == other) return true;
  // A battery asks what the properties of its task ask too.
  if (other == "tasks") return folder == "mistakes";
  const auto only = kOnly.find(folder);
  if (only != kOnly.end() && !only->second.contains(other)) return false;
  return std::ranges::find(kFolders, other) < std::ranges::find(kFolders, folder);
}

TEST(layers, point_downwards) {
  const std::vector<Source> all = sources();
  ASSERT_GT(all.size(), 150U);
  for (const std::string& folder : kFolders) {
    EXPECT_TRUE(std::ranges::any_of(all, [&](const Source& s) { return s.folder == folder; }))
        << folder;
  }
  for (const Source& source : all) {
    for (const auto& [other, line] : included(source.text)) {
      EXPECT_TRUE(may_include(source.folder, other))
          << "grader/" << source.path.string() << ": " << line;
    }
  }
}

// RapidCheck may change what it does not promise.
TEST(layers, private_parts_of_rapidcheck_are_in_one_file) {
  std::vector<std::string> users;
  for (const Source& source : sources()) {
    if (source.text.find("rc::"
                         "detail") != std::string::npos)
      users.push_back(source.path);
  }
  std::erase(users, "check/find_failure.h");  // it names them in a comment
  EXPECT_EQ(users, std::vector<std::string>{"check/find_failure.cpp"});
}

TEST(layers, are_namespaces) {
  for (const Source& source : sources()) {
    if (source.path.extension() != ".h" || source.folder == "self_check") continue;
    const std::string name =
        "namespace grader::" + (source.folder == "tasks" ? "check" : source.folder);
    const bool own = source.text.find(name) != std::string::npos;
    EXPECT_TRUE(own || source.text.find("namespace ") == std::string::npos)
        << "grader/" << source.path.string() << " is not in " << name;
  }
}

TEST(layers, of_the_renderer_and_the_tests_stand_apart) {
  for (const auto& entry : fs::recursive_directory_iterator(FIRSTLIGHT_ROOT "/pt")) {
    const std::string type = entry.path().extension();
    if (type != ".cpp" && type != ".h") continue;
    EXPECT_EQ(base::read_file(entry.path()).find("#include \"grader/"), std::string::npos)
        << entry.path();
  }
}

}  // namespace
}  // namespace grader::self_check
