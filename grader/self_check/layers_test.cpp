// The folders of the grader and of the renderer, and those that each may include. A folder uses those
// that stand before it in the list; so no two use each other, and who reads one from the bottom up
// needs no other. The table of them, with where things are, is in decision 32.
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
const std::vector<std::string> kFolders{"base",     "process", "sandbox",  "results",   "check",
                                        "mistakes", "tasks",   "wire",     "pictures",  "report",
                                        "judge",    "intake",  "programs", "self_check"};

// Folders for which the order alone would allow too much, each with all that it may include.
const std::map<std::string, std::set<std::string>> kOnly{{"results", {"base"}},
                                                         {"check", {"results"}},
                                                         {"tasks", {"check", "mistakes"}},
                                                         {"mistakes", {"results", "check"}},
                                                         {"intake", {"base"}},
                                                         {"report", {"base", "results"}}};

// The folders of pt/, likewise.
const std::vector<std::string> kRenderer{"math",  "sampling", "geometry", "accel",
                                         "scene", "tasks",    "image",    "render"};

// The only includes upwards: here the renderer calls tasks, whose contracts speak of its scenes.
const std::map<std::string, std::set<std::string>> kCallsOfTasks{
    {"geometry/primitives.h", {"hit_sphere.h", "hit_triangle.h"}},
    {"scene/tracer.cpp", {"build_bvh.h", "hit_bvh.h"}}};

// Code that is linked in the place of a task or of the slot radiance is in namespace pt, as they are; so are counting versions
// and mocks of tasks.
const std::set<std::string> kInPlaceOfTasks{"self_check/obedient_hit_sphere.cpp",
                                            "wire/implementation.cpp"};

// Files that have a part in the namespace of another folder: Repeated of check/repeat.h, for tasks
// in a worker.
const std::map<std::string, std::string> kSpecialised{{"wire/call.h", "grader::check"}};

struct Source {
  fs::path path;
  std::string folder, text;  // folder: empty for files of grader/ itself
};

// Solutions of a task, right and wrong ones, and submissions that attack are not the grader's code.
bool is_ours(const fs::path& below) {
  const auto depth = std::distance(below.begin(), below.end());
  if (depth == 1) return true;
  const std::string folder = *below.begin();
  if (folder == "tasks") return depth == 3;
  return folder != "self_check" || depth == 2;
}

std::vector<Source> sources() {
  std::vector<Source> all;
  const fs::path grader = FIRSTLIGHT_ROOT "/grader";
  for (const auto& entry : fs::recursive_directory_iterator(grader)) {
    const fs::path below = fs::relative(entry.path(), grader);
    const std::string folder = below.has_parent_path() ? below.begin()->string() : "";
    const std::string type = entry.path().extension();
    const bool code = type == ".cpp" || type == ".h";
    if (code && is_ours(below)) all.push_back({below, folder, base::read_file(entry.path())});
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

// Folders before it in the list; files of grader/ itself stand before all folders.
bool may_include(const std::string& folder, const std::string& other) {
  if (folder == other) return true;
  if (folder.empty()) return false;
  if (other == "tasks") return false;
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
    EXPECT_TRUE(source.folder.empty() || std::ranges::count(kFolders, source.folder) > 0)
        << "grader/" << source.folder << " is not in the list";
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

// Namespaces with a name that a text opens, but for those in others: "grader::check".
std::set<std::string> namespaces(const std::string& text) {
  static const std::regex opens(R"(^namespace ([\w:]+) \{.*)");
  std::set<std::string> names;
  std::istringstream lines(text);
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, found, opens)) names.insert(found[1]);
  }
  return names;
}

// The namespace of a source of ours; with calls.h, which is a table for wire/.
std::string namespace_of(const Source& source) {
  if (source.path == "calls.h") return "grader::wire";
  if (source.folder.empty()) return "grader";
  const bool battery =
      source.text.find("#include \"grader/mistakes/battery.h\"") != std::string::npos;
  if (battery && source.folder == "tasks") return "grader::mistakes";
  return "grader::" + (source.folder == "tasks" ? "check" : source.folder);
}

// Namespaces of others, as pt and CLI, may be opened. A test is in that of what it tests.
bool may_open(const Source& source, const std::string& name) {
  const std::string own = namespace_of(source);
  if (name == own || name.starts_with(own + "::") || !name.starts_with("grader")) return true;
  const bool tests =
      source.folder == "self_check" && source.path.stem().string().ends_with("_test");
  const auto specialised = kSpecialised.find(source.path);
  return (tests && name.starts_with("grader::")) ||
         (specialised != kSpecialised.end() && specialised->second == name);
}

// Programs have main() in no namespace, and the rest of them in one without a name. What ./run measure calls in is in the
// namespace of that.
bool may_do_without(const Source& source) {
  const std::string name = source.path.filename();
  const bool of_a_task = name == "counting.cpp" || name == "mock.cpp" || name == "measure.cpp";
  return kInPlaceOfTasks.contains(source.path) || (source.folder == "tasks" && of_a_task) ||
         source.text.find("int main(") != std::string::npos ||
         (source.path.extension() == ".h" && source.text.find("namespace ") == std::string::npos);
}

TEST(layers, are_namespaces) {
  for (const Source& source : sources()) {
    const std::set<std::string> opened = namespaces(source.text);
    for (const std::string& name : opened) {
      EXPECT_TRUE(may_open(source, name))
          << "grader/" << source.path.string() << " is not in " << namespace_of(source);
    }
    const bool any = std::ranges::any_of(
        opened, [](const std::string& name) { return name.starts_with("grader"); });
    EXPECT_TRUE(any || may_do_without(source))
        << "grader/" << source.path.string() << " is not in " << namespace_of(source);
  }
}

TEST(layers, of_the_renderer_point_downwards) {
  static const std::regex include(R"(^#include "(pt|grader)/(?:(\w+)/)?(.*)\"$)");
  std::set<std::string> calls;
  for (const auto& entry : fs::recursive_directory_iterator(FIRSTLIGHT_ROOT "/pt")) {
    const std::string type = entry.path().extension();
    if (type != ".cpp" && type != ".h") continue;
    const fs::path path = fs::relative(entry.path(), FIRSTLIGHT_ROOT "/pt");
    const std::string folder = path.has_parent_path() ? path.begin()->string() : "";
    const auto place = std::ranges::find(kRenderer, folder);
    EXPECT_TRUE(folder.empty() || place != kRenderer.end()) << path << " is not in the list";
    std::istringstream lines(base::read_file(entry.path()));
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
      if (!std::regex_match(line, found, include)) continue;
      const auto upward = kCallsOfTasks.find(path);
      const bool calls_task =
          found[2] == "tasks" && upward != kCallsOfTasks.end() && upward->second.contains(found[3]);
      if (calls_task) calls.insert(path);
      const bool beside = found[2] == "" || (!folder.empty() && found[2] == folder);
      const bool below = !folder.empty() && std::find(kRenderer.begin(), place, found[2]) != place;
      EXPECT_TRUE(found[1] == "pt" && (calls_task || beside || below))
          << "pt/" << path.string() << ": " << line;
    }
  }
  EXPECT_EQ(calls.size(), kCallsOfTasks.size()) << "an exception that nothing needs";
}

// A row of decision 32: "| Where is the hash? | `sha256` in `grader/base/sha256.cpp` |".
TEST(layers, hold_what_the_decision_says_is_where) {
  static const std::regex row(R"(\| (.*\?) \| `([^`]+)` in `([^`]+)` \|)");
  std::istringstream lines(
      base::read_file(FIRSTLIGHT_ROOT "/docs/decisions/0032-folders-of-the-grader.md"));
  std::smatch found;
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("? |") == std::string::npos) continue;
    ++count;
    ASSERT_TRUE(std::regex_match(line, found, row)) << line;
    const fs::path file = fs::path(FIRSTLIGHT_ROOT) / found[3].str();
    ASSERT_TRUE(fs::is_regular_file(file)) << line;
    EXPECT_NE(base::read_file(file).find(found[2]), std::string::npos) << line;
  }
  EXPECT_GE(count, 22);
}

}  // namespace
}  // namespace grader::self_check
