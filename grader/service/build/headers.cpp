#include "grader/service/build/headers.h"

#include "grader/service/audit/may_call.h"
#include "pt/file.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

namespace grader::build {

namespace fs = std::filesystem;

namespace {

// The path and all headers that it includes, directly or not.
void add_reached(const std::string& path, const Headers& all, std::set<std::string>& reached) {
  const auto found = all.find(path);
  if (found == all.end() || !reached.insert(path).second) return;
  std::istringstream lines(found->second);
  constexpr std::string_view kInclude = "#include \"";
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(kInclude, 0) != 0) continue;
    add_reached(line.substr(kInclude.size(), line.rfind('"') - kInclude.size()), all, reached);
  }
}

// Returns whether tasks are built from this header. All other headers belong to the renderer.
bool is_common(const std::string& path) {
  for (const char* folder : {"pt/math/", "pt/geometry/", "pt/sampling/", "pt/tasks/"}) {
    if (path.rfind(folder, 0) == 0) return true;
  }
  for (const char* file : {"pt/error.h", "pt/todo.h", "pt/scene/camera.h", "pt/scene/light.h",
                           "pt/scene/material.h", "pt/scene/field_of_view.h"}) {
    if (path == file) return true;
  }
  return false;
}

bool has_nothing_of_the_renderer(const std::string& path, const Headers& all) {
  const std::set<std::string> reached = reached_from(path, all);
  return std::all_of(reached.begin(), reached.end(), is_common);
}

}  // namespace

std::set<std::string> reached_from(const std::string& path, const Headers& all) {
  std::set<std::string> reached;
  add_reached(path, all, reached);
  return reached;
}

Headers public_headers(const std::string& root) {
  Headers headers;
  for (const auto& entry : fs::recursive_directory_iterator(root + "/pt")) {
    if (entry.path().extension() != ".h") continue;
    headers[entry.path().lexically_relative(root)] = pt::read_file(entry.path());
  }
  return headers;
}

std::string code_of(const std::string& header) {
  for (const char* word : {"assert", "__LINE__", "R\"", "\\\n"}) {
    if (header.find(word) != header.npos) return header;
  }
  std::string code;
  for (std::size_t i = 0; i < header.size();) {
    const char c = header[i];
    std::size_t end = i + 1;
    if (header.compare(i, 2, "//") == 0) {
      i = std::min(header.find('\n', i), header.size());
      continue;
    }
    if (header.compare(i, 2, "/*") == 0) {
      const std::size_t close = header.find("*/", i + 2);
      i = close == header.npos ? header.size() : close + 2;
      code += ' ';
      continue;
    }
    if (c == '"' || c == '\'') {
      while (end < header.size() && header[end] != c) end += header[end] == '\\' ? 2 : 1;
      end = std::min(end + 1, header.size());
    }
    if (c != '\n' || (!code.empty() && code.back() != '\n')) code.append(header, i, end - i);
    i = end;
  }
  return code;
}

Headers headers_for(const Task& task, const Headers& all) {
  std::set<std::string> known = reached_from("pt/tasks/" + task.slug + ".h", all);
  for (const auto& [path, text] : all) {
    const std::string name = "pt::" + std::filesystem::path(path).stem().string();
    const bool called = audit::may_call(task, name);
    if (called || has_nothing_of_the_renderer(path, all)) add_reached(path, all, known);
  }
  Headers headers;
  for (const auto& [path, text] : all) {
    headers[path] =
        known.contains(path)
            ? text
            : fmt::format("#error \"{} may not include {}: it does not need that header\"\n",
                          task.slug, path);
  }
  return headers;
}

}  // namespace grader::build
