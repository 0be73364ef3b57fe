#include "grader/door/flatten.h"

#include "grader/door/code.h"
#include "grader/door/edits.h"
#include "grader/door/stubs.h"
#include "pt/error.h"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include <fmt/format.h>

namespace grader::door {

namespace fs = std::filesystem;

namespace {

constexpr std::array kRoots{"src/", "CGL/include/", "CGL/include/CGL/"};
constexpr std::array kPlaces{"src/pathtracer/",   "src/scene/", "src/",
                             "src/static_scene/", "CGL/src/",   "CGL/include/CGL/"};
// The colours, vectors and matrices of the course.
constexpr std::array kMath{"spectrum.h",   "vector2D.cpp",  "vector3D.cpp",
                           "vector4D.cpp", "matrix3x3.cpp", "matrix4x4.cpp"};
constexpr std::array kOfPaths{"ray.h", "intersection.h"};
constexpr int kMaxDepth = 64;                           // files that include files
constexpr std::size_t kMaxText = std::size_t{4} << 20;  // the judge refuses a larger file

// The name and the kind of brackets of `#include "name"`; no name: the line is none.
struct Include {
  std::string name{};
  bool is_quoted = false;
};

Include include_in(const std::string& line) {
  std::istringstream words(line);
  std::string directive;
  char c = ' ';
  if (!(words >> c) || c != '#') return {};
  while (words.get(c) && (c == ' ' || c == '\t')) {
  }
  while (words && c >= 'a' && c <= 'z' && directive.size() < 8) {
    directive += c;
    if (!words.get(c)) break;
  }
  if (directive != "include" && directive != "import") return {};
  while (words && (c == ' ' || c == '\t')) words.get(c);
  if (!words || (c != '"' && c != '<')) return {};
  std::string name;
  std::getline(words, name, c == '"' ? '"' : '>');
  return {name, c == '"'};
}

// The path of a learner's file by its name; empty if it is not there.
std::string place_of(const Clone& clone, const std::string& name) {
  for (const char* folder : kPlaces) {
    if (clone.find(folder + name) != nullptr) return folder + name;
  }
  return "";
}

// The text of a task, while it is put together.
class Flat {
 public:
  Flat(const Clone& clone, const Texts& texts, Generation generation, bool is_of_paths)
      : clone_(clone), texts_(texts), generation_(generation), is_of_paths_(is_of_paths) {}

  // Adds a file of the clone with all that it includes, each file once.
  void add(const std::string& path) { add_file(path, clone_.find(path)->text, true, 0); }

  const std::string& text() const { return text_; }
  const std::set<std::string>& standard() const { return standard_; }

 private:
  // The seam that stands in for a file: it is found by the end of the path. Those in paths/ are for
  // the tasks of paths alone.
  const std::string* seam_of(const std::string& path) const {
    for (const auto& [name, text] : texts_.seams) {
      const bool is_of_paths = name.starts_with("paths/");
      const std::string end = '/' + (is_of_paths ? name.substr(6) : name);
      if (('/' + path).ends_with(end) && (is_of_paths_ || !is_of_paths)) return &text;
    }
    return nullptr;
  }

  // Looks where a compiler would. A path is made plain first, so that none leads out of the clone.
  std::string find(const std::string& name, const std::string& from) const {
    std::vector<std::string> places{fs::path(from).parent_path().generic_string() + '/'};
    places.insert(places.end(), kRoots.begin(), kRoots.end());
    for (const std::string& place : places) {
      std::string path = fs::path(place + name).lexically_normal().generic_string();
      if (clone_.find(path) != nullptr) return path;
    }
    return "";
  }

  void add_include(const Include& include, const std::string& from, const std::string& line,
                   int depth) {
    const std::string path = find(include.name, from);
    if (const std::string* seam = seam_of(path.empty() ? include.name : path)) {
      const std::string shown = "door/seams/" + fs::path(include.name).filename().string();
      return add_file(shown, *seam, false, depth + 1);
    }
    if (!path.empty()) {
      const Source& file = *clone_.find(path);
      if (!file.refused.empty()) {
        text_ += fmt::format("#error \"{}: {}\"\n", path, file.refused);
      } else if (depth >= kMaxDepth) {
        text_ += fmt::format("#error \"files include files, more than {} deep\"\n", kMaxDepth);
      } else {
        add_file(path, file.text, true, depth + 1);
      }
    } else if (include.is_quoted) {
      text_ += line + '\n';  // the compiler says that it is not there, if the line counts at all
    } else {
      standard_.insert(include.name);
      text_ += '\n';
    }
  }

  void add_file(const std::string& path, const std::string& given, bool is_learners, int depth) {
    if (!seen_.insert(path).second) return void(text_ += '\n');
    if (text_.size() > kMaxText) return;
    const std::string text = is_learners ? edited(given, path, generation_) : given;
    std::istringstream lines(text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text);
    std::istringstream code(only_code(text));
    text_ += fmt::format("\n#line 1 \"{}\"\n", path);
    int number = 0;
    for (std::string line, coded; std::getline(lines, line); ++number) {
      std::getline(code, coded);
      // An include inside a comment is none.
      const Include include = coded.find('#') == coded.npos ? Include{} : include_in(line);
      if (include.name.empty()) {
        text_ += (coded.find("#pragma once") == coded.npos ? line : "") + '\n';
        continue;
      }
      add_include(include, path, line, depth);
      text_ += fmt::format("#line {} \"{}\"\n", number + 2, path);
    }
  }

  const Clone& clone_;
  const Texts& texts_;
  Generation generation_;
  bool is_of_paths_;
  std::set<std::string> seen_, standard_;
  std::string text_;
};

// "#include <cmath>" and so on. What another system has may not be here.
std::string includes_of(const std::set<std::string>& standard) {
  std::string text =
      "#include <cmath>\n#include <cstdarg>\n#include <cstdint>\n#include <cstdio>\n#include "
      "<string>\n#include "
      "<utility>\n#include <vector>\n";
  for (const std::string& name : standard) {
    text += fmt::format("#if __has_include(<{0}>)\n#include <{0}>\n#endif\n", name);
  }
  return text;
}

}  // namespace

std::string functions_of(const Clone& clone, const Texts& texts, const std::string& slug) {
  const Adapter& adapter = texts.tasks.at(slug);
  const std::string path = place_of(clone, adapter.sources.at(0));
  if (path.empty()) return "";
  const std::string& text = clone.find(path)->text;
  const std::string code = only_code(text);
  std::string functions;
  std::set<std::string> names(adapter.functions.begin(), adapter.functions.end());
  for (const Stub& stub : adapter.stubs) names.insert(stub.function);
  for (const std::string& name : names) {
    if (name.empty()) continue;
    for (const Definition& each : definitions_of(code, name))
      functions.append(text, each.name, each.end - each.name).append("\n");
  }
  return functions;
}

std::string flatten(const Clone& clone, const Texts& texts, const std::string& slug) {
  const Adapter& adapter = texts.tasks.at(slug);
  const Course course = course_of(clone);
  const bool is_of_paths = std::ranges::count(adapter.sources, "pathtracer.cpp") > 0;
  Flat flat(clone, texts, course.generation, is_of_paths);
  std::vector<std::string> names;
  if (is_of_paths) names.insert(names.end(), kOfPaths.begin(), kOfPaths.end());
  names.insert(names.end(), kMath.begin(), kMath.end());
  names.insert(names.end(), adapter.sources.begin(), adapter.sources.end());
  for (const std::string& name : names) {
    if (const std::string path = place_of(clone, name); !path.empty()) flat.add(path);
  }
  const std::string first = place_of(clone, adapter.sources.at(0));
  const bool is_written =
      first.empty() ||
      !is_unwritten(adapter, only_code(edited(clone.find(first)->text, first, course.generation)));
  const std::string ours = texts.around.at("common") + (is_of_paths ? texts.around.at("path") : "");
  return fmt::format(
      "#include \"pt/tasks/{0}.h\"\n#include \"pt/sampling/sampler.h\"\n#include "
      "\"pt/todo.h\"\n{1}{2}"
      "#define FL_GENERATION {3}\n#define FL_ACCUMULATES {4}\n#define FL_WRITTEN {5}\n"
      "#define FL_SLUG \"{0}\"\n{6}namespace {{\n{7}\n#line 1 \"door/around\"\n{8}"
      "#line 1 \"door/tasks/{0}\"\n{9}",
      slug, includes_of(flat.standard()), adapter.includes, static_cast<int>(course.generation),
      static_cast<int>(course.accumulates), static_cast<int>(is_written), texts.around.at("before"),
      flat.text(), ours, adapter.code);
}

}  // namespace grader::door
