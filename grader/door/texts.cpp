#include "grader/door/texts.h"

#include "pt/error.h"
#include "pt/file.h"

#include <sstream>

#include <fmt/format.h>

namespace grader::door {

namespace fs = std::filesystem;

namespace {

constexpr const char* kNext = "---";

std::string rest_until(std::istream& lines, std::string_view end) {
  std::string text;
  for (std::string line; std::getline(lines, line) && line != end;) text += line + '\n';
  return text;
}

std::vector<std::string> words_of(std::istream& line) {
  std::vector<std::string> words;
  for (std::string word; line >> word;) words.push_back(word);
  return words;
}

AddedPromise promise_in(std::istream& line) {
  AddedPromise promise;
  line >> promise.since >> promise.name >> std::ws;
  std::getline(line, promise.words);
  return promise;
}

Adapter read_adapter(const fs::path& path) {
  std::istringstream lines(pt::read_file(path));
  Adapter adapter;
  for (std::string line; std::getline(lines, line) && line != kNext;) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    if (what == "promise") {
      adapter.promises.push_back(promise_in(words));
      continue;
    }
    if (what == "named") {
      std::string name;
      words >> name >> std::ws;
      std::getline(words, adapter.named[name]);
      continue;
    }
    const std::vector<std::string> all = words_of(words);
    if (what == "sources") {
      adapter.sources = all;
    } else if (what == "function") {
      adapter.functions = all;
    } else if (what == "cause" && all.size() == 1) {
      adapter.causes.insert(all[0]);
    } else if (what == "together" && all.size() == 1) {
      adapter.together = all[0];
    } else if (what == "stub" && !all.empty()) {
      adapter.stubs.push_back({all[0] == "file" ? "" : all[0], {all.begin() + 1, all.end()}});
    } else {
      throw pt::Error(
          fmt::format("{}: '{}' means nothing; see grader/door/flatten.h", path.string(), line));
    }
  }
  adapter.includes = rest_until(lines, kNext);
  adapter.code = rest_until(lines, kNext);
  return adapter;
}

}  // namespace

Texts read_texts(const fs::path& folder) {
  Texts texts;
  for (const auto& entry : fs::directory_iterator(folder / "tasks"))
    texts.tasks[entry.path().stem()] = read_adapter(entry.path());
  for (const auto& entry : fs::recursive_directory_iterator(folder / "seams")) {
    if (entry.is_regular_file())
      texts.seams[entry.path().lexically_relative(folder / "seams").replace_extension(".h")] =
          pt::read_file(entry.path());
  }
  for (const auto& entry : fs::directory_iterator(folder / "around"))
    texts.around[entry.path().stem()] = pt::read_file(entry.path());
  return texts;
}

}  // namespace grader::door
