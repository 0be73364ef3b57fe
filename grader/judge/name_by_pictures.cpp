#include "grader/judge/name_by_pictures.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::judge {

namespace {

std::string sentence_of(const std::string& file, const results::TaskResult& task,
                        const std::string& name) {
  const std::string start = fmt::format("{{\"task\":\"{}\",\"name\":\"{}\"", task.slug, name);
  std::string sentence;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(start)) continue;
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (json.is_object()) sentence = json.value("sentence", "");
  }
  return sentence;
}

// "a, b" -> a and b: mistakes that the task's answers cannot tell apart.
std::set<std::string> names_in(const std::string& text) {
  std::set<std::string> names;
  std::istringstream in(text);
  for (std::string name; std::getline(in >> std::ws, name, ',');) names.insert(name);
  return names;
}

// Promises and pictures must not contradict each other: of the mistakes that the pictures
// allow, those that the task's answers allow too are left. Where none is left, nothing is named.
std::vector<std::string> agreed(results::TaskResult& task, std::vector<std::string> by_pictures) {
  if (task.mistake.empty()) return by_pictures;
  std::set<std::string> names = names_in(task.mistake.name);
  for (const results::PictureResult& picture : task.pictures) {
    for (const std::string& name : picture.unlike) names.erase(name);
  }
  if (!by_pictures.empty()) {
    std::erase_if(by_pictures, [&](const std::string& name) { return !names.contains(name); });
    if (by_pictures.empty()) names.clear();
  }
  if (names.empty()) {
    task.mistake = {};
    return {};
  }
  return by_pictures;
}

}  // namespace

std::vector<std::string> candidates(const std::vector<results::PictureResult>& pictures) {
  std::set<std::string> names;
  for (const results::PictureResult& picture : pictures) {
    names.insert(picture.like.begin(), picture.like.end());
  }
  for (const results::PictureResult& picture : pictures) {
    for (const std::string& name : picture.unlike) names.erase(name);
  }
  return {names.begin(), names.end()};
}

void name_by_pictures(results::TaskResult& task, const std::string& file) {
  const std::vector<std::string> names = agreed(task, candidates(task.pictures));
  const std::string sentence = names.size() == 1 ? sentence_of(file, task, names[0]) : "";
  for (results::PictureResult& picture : task.pictures) {
    if (!sentence.empty() && std::count(picture.like.begin(), picture.like.end(), names[0]) > 0) {
      picture.mistake = names[0];
      picture.text += picture.text.ends_with('?') ? " " : ". ";
      picture.text += "A known mistake makes the same picture: " + sentence;
    }
    picture.like.clear();
    picture.unlike.clear();
  }
}

}  // namespace grader::judge
