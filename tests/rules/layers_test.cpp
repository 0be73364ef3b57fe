// The rooms (folders) of the grader, the measurements, the write-up and the renderer, and the rooms
// that each may include: only rooms before it in the list. So no two use each other, and a reader
// who starts from the bottom needs no later room. Decision 32 has the table of rooms.
#include "pt/file.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

namespace grader::tests {
namespace {

namespace fs = std::filesystem;

using Rooms = std::vector<std::string>;

// From the bottom up. The core of the grader judges a task; the service exists because a
// submission's code comes from somebody else.
const Rooms kCore{"grader/base",    "grader/results",  "grader/door",
                  "grader/explain", "grader/check",    "grader/mistakes",
                  "grader/tasks",   "grader/pictures", "grader/report"};
const Rooms kService{"grader/service/process", "grader/service/sandbox", "grader/service/wire",
                     "grader/service/audit",   "grader/service/build",   "grader/service/judging",
                     "grader/examples",        "grader/renderers",       "grader/service/platforms",
                     "grader/service/intake",  "grader/service/classes"};
const Rooms kMeasure{"measure/charts", "measure/renders", "measure/scene", "measure/calls",
                     "measure/failure"};
const std::string kWriteup = "writeup";
const std::string kView = "view";
const std::string kSite = "site";

// These rooms contain programs, and nobody includes their headers.
const Rooms kPrograms{"grader/watch", "grader/programs"};

const Rooms kRooms = [] {
  Rooms all;
  for (const Rooms& rooms : {kCore, kService, kMeasure, {kWriteup}, {kView}, {kSite}, kPrograms})
    all.insert(all.end(), rooms.begin(), rooms.end());
  return all;
}();

// Rooms for which the order alone would allow too much, with all rooms that they may include.
const std::map<std::string, std::set<std::string>> kOnly{
    {"grader/results", {"grader/base"}},
    {"grader/explain", {}},
    {"grader/check", {"grader/results", "grader/explain"}},
    {"grader/mistakes", {"grader/results", "grader/check"}},
    {"grader/tasks", {"grader/explain", "grader/check", "grader/mistakes"}},
    {"grader/pictures", {"grader/base", "grader/results"}},
    {"grader/report", {"grader/base", "grader/results"}},
    {"grader/service/process", {"grader/base"}},
    {"grader/service/sandbox", {"grader/base", "grader/service/process"}},
    {"grader/door", {"grader/base", "grader/results"}},
    {"grader/service/intake",
     {"grader/base", "grader/door", "grader/report", "grader/service/build",
      "grader/service/process", "grader/service/sandbox"}},
    {"grader/service/platforms", {"grader/base", "grader/results", "grader/report"}},
    {kSite, {kWriteup}},
    {kView,
     {"grader/base", "grader/explain", "grader/pictures", "grader/report", "grader/service/process",
      "grader/service/sandbox"}}};

// Rooms whose namespace is not grader:: and the last part of their name.
const std::map<std::string, std::string> kNamespaces{{"grader", "grader"},
                                                     {"grader/tasks", "grader::check"},
                                                     {"measure/charts", "measure"},
                                                     {"measure/renders", "measure"},
                                                     {"measure/scene", "measure::scene"},
                                                     {"writeup", "writeup"},
                                                     {"view", "view"},
                                                     {"site", "site"},
                                                     {"measure/calls", "measure::calls"},
                                                     {"measure/failure", "measure::failure"}};

// The folders of pt/, from the bottom up.
const std::vector<std::string> kRenderer{"math",  "sampling", "geometry", "accel",   "scene",
                                         "tasks", "image",    "render",   "examples"};

// The only includes upwards: the renderer calls tasks, whose contracts mention its scenes.
const std::map<std::string, std::set<std::string>> kCallsOfTasks{
    {"geometry/primitives.h", {"hit_sphere.h", "hit_triangle.h"}},
    {"scene/tracer.cpp", {"build_bvh.h", "hit_bvh.h"}}};

// Files with a part in another room's namespace. Their definitions are declared in that room
// (Repeated of check/language/repeat.h, and serve()), or replace a task.
const std::map<std::string, std::string> kElsewhere{
    {"grader/service/wire/call.h", "grader::check"},
    {"grader/service/wire/implementation.cpp", "pt"},
    {"grader/examples/runner.cpp", "pt"},
    {"view/worker/paths.cpp", "pt"},
    {"site/live/recorded.cpp", "pt"},
    {"measure/calls/serve.cpp", "grader::wire"}};

struct Source {
  std::string path, room, text;

  std::string name() const { return fs::path(path).filename(); }
};

// A room is the folder of a file, or one of the folders above it.
std::string room_of(const std::string& path) {
  std::string longest;
  for (const std::string& room : kRooms) {
    if (path.starts_with(room + "/") && room.size() > longest.size()) longest = room;
  }
  return longest.empty() ? fs::path(path).parent_path().string() : longest;
}

// Solutions of a task do not belong to the grader's code.
bool is_ours(const std::string& path) {
  return !path.starts_with("grader/tasks/") || std::ranges::count(path, '/') == 3;
}

std::vector<Source> sources() {
  std::vector<Source> all;
  for (const char* folder : {"grader", "measure", "writeup", "view", "site"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FIRSTLIGHT_ROOT) / folder)) {
      const std::string path = fs::relative(entry.path(), FIRSTLIGHT_ROOT);
      const std::string type = entry.path().extension();
      const bool code = type == ".cpp" || type == ".h";
      if (code && is_ours(path)) all.push_back({path, room_of(path), pt::read_file(entry.path())});
    }
  }
  return all;
}

// Returns the rooms whose headers a text includes, with the include line.
std::map<std::string, std::string> included(const std::string& text) {
  static const std::regex include(
      R"(^#include "((?:grader|measure|writeup|view|site|tests|bench)/.*)\".*)");
  std::map<std::string, std::string> rooms;
  std::istringstream lines(text);
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, found, include)) rooms[room_of(found[1])] = line;
  }
  return rooms;
}

bool is_in(const Rooms& rooms, const std::string& room) {
  return std::ranges::find(rooms, room) != rooms.end();
}

// Files of grader/ itself come before all rooms.
bool may_include(const Source& source, const std::string& other) {
  const std::string& room = source.room;
  if (room == other || other == "grader") return true;
  if (room == "grader") return false;
  // The part of ./run measure for one task is in that task's folder.
  if (room == "grader/tasks" && source.name() == "measure.cpp")
    return is_in(kCore, other) || other == "measure/calls";
  // The view judges hits by the same oracles.
  if (other == "grader/tasks" && room == kView) return true;
  if (other == "grader/tasks" || is_in(kPrograms, other)) return false;
  const auto only = kOnly.find(room);
  if (only != kOnly.end()) return only->second.contains(other);
  // Programs of the grader need no measurements.
  if (is_in(kPrograms, room)) return is_in(kCore, other) || is_in(kService, other);
  return std::ranges::find(kRooms, other) < std::ranges::find(kRooms, room);
}

TEST(layers, point_downwards) {
  const std::vector<Source> all = sources();
  ASSERT_GT(all.size(), 400U);
  for (const std::string& room : kRooms) {
    EXPECT_TRUE(std::ranges::any_of(all, [&](const Source& s) { return s.room == room; })) << room;
  }
  for (const Source& source : all) {
    EXPECT_TRUE(source.room == "grader" || is_in(kRooms, source.room))
        << source.room << " is not in the list";
    for (const auto& [other, line] : included(source.text)) {
      EXPECT_TRUE(may_include(source, other)) << source.path << ": " << line;
    }
  }
}

// RapidCheck may change everything that it does not promise.
TEST(layers, private_parts_of_rapidcheck_are_in_one_file) {
  std::vector<std::string> users;
  for (const Source& source : sources()) {
    if (source.text.find("rc::"
                         "detail") != std::string::npos)
      users.push_back(source.path);
  }
  std::erase(users, "grader/check/language/find_failure.h");  // it mentions them in a comment
  EXPECT_EQ(users, std::vector<std::string>{"grader/check/language/find_failure.cpp"});
}

// Returns the outermost namespaces that a text opens, such as "grader::check".
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

// Returns the namespace of one of our sources. calls.h is a table for the wire.
std::string namespace_of(const Source& source) {
  if (source.path == "grader/calls.h") return "grader::wire";
  if (source.room == "grader/tasks") {
    if (source.name() == "measure.cpp") return "measure::calls";
    if (source.text.find("#include \"grader/mistakes/battery.h\"") != std::string::npos)
      return "grader::mistakes";
  }
  const auto named = kNamespaces.find(source.room);
  return named == kNamespaces.end() ? "grader::" + fs::path(source.room).filename().string()
                                    : named->second;
}

// Namespaces of other libraries, such as CLI, may be opened.
bool may_open(const Source& source, const std::string& name) {
  const std::string own = namespace_of(source);
  const auto elsewhere = kElsewhere.find(source.path);
  return name == own || name.starts_with(own + "::") ||
         !std::regex_match(name, std::regex("(grader|measure|writeup|view|site)(::.*)?")) ||
         (elsewhere != kElsewhere.end() && elsewhere->second == name);
}

// Programs use no namespace for main() and an unnamed one for the rest. Mocks are in namespace pt.
bool may_do_without(const Source& source) {
  const std::string name = source.name();
  const bool stands_in = name == "counting.cpp" || name == "mock.cpp";
  return kElsewhere.contains(source.path) || (source.room == "grader/tasks" && stands_in) ||
         source.text.find("int main(") != std::string::npos ||
         (source.path.ends_with(".h") && source.text.find("namespace ") == std::string::npos);
}

TEST(layers, are_namespaces) {
  for (const Source& source : sources()) {
    const std::set<std::string> opened = namespaces(source.text);
    for (const std::string& name : opened) {
      EXPECT_TRUE(may_open(source, name)) << source.path << " is not in " << namespace_of(source);
    }
    const std::string own = namespace_of(source);
    const bool any = std::ranges::any_of(opened, [&](const std::string& name) {
      return name == own || name.starts_with(own + "::");
    });
    EXPECT_TRUE(any || may_do_without(source)) << source.path << " is not in " << own;
  }
}

TEST(layers, of_the_renderer_point_downwards) {
  static const std::regex include(
      R"(^#include "(pt|grader|measure|writeup|view|site|tests)/(?:(\w+)/)?(.*)\"$)");
  std::set<std::string> calls;
  for (const auto& entry : fs::recursive_directory_iterator(FIRSTLIGHT_ROOT "/pt")) {
    const std::string type = entry.path().extension();
    if (type != ".cpp" && type != ".h") continue;
    const fs::path path = fs::relative(entry.path(), FIRSTLIGHT_ROOT "/pt");
    const std::string folder = path.has_parent_path() ? path.begin()->string() : "";
    const auto place = std::ranges::find(kRenderer, folder);
    EXPECT_TRUE(folder.empty() || place != kRenderer.end()) << path << " is not in the list";
    std::istringstream lines(pt::read_file(entry.path()));
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
      pt::read_file(FIRSTLIGHT_ROOT "/docs/decisions/0032-folders-of-the-grader.md"));
  std::smatch found;
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("? |") == std::string::npos) continue;
    ++count;
    ASSERT_TRUE(std::regex_match(line, found, row)) << line;
    const fs::path file = fs::path(FIRSTLIGHT_ROOT) / found[3].str();
    ASSERT_TRUE(fs::is_regular_file(file)) << line;
    EXPECT_NE(pt::read_file(file).find(found[2]), std::string::npos) << line;
  }
  EXPECT_GE(count, 35);
}

}  // namespace
}  // namespace grader::tests
