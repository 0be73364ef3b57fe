#include "grader/judge/hints.h"

#include "grader/judge/files.h"
#include "grader/judge/promises.h"
#include "grader/report/wrap.h"
#include "pt/error.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace grader {

namespace {

namespace fs = std::filesystem;

constexpr int kTiers = 3;

// First line: the last tier that was given; then the names of the promises that fail.
std::string memory_path(const Config& config, const std::string& slug) {
  return config.work + "/hints/" + slug;
}

std::vector<std::string> recall(const Config& config, const std::string& slug) {
  const std::string path = memory_path(config, slug);
  if (!fs::exists(path)) return {"0"};
  std::vector<std::string> lines = lines_of(read_file(path));
  if (lines.empty()) lines.push_back("0");
  return lines;
}

void remember(const Config& config, const std::string& slug,
              const std::vector<std::string>& lines) {
  fs::create_directories(config.work + "/hints");
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  write_file(memory_path(config, slug), text);
}

}  // namespace

std::string hint_text(const std::string& hints, int tier,
                      const std::vector<std::string>& promises) {
  std::string text;
  int current = 0;
  bool wanted = true;  // the section of a promise, or what comes before all of them
  for (const std::string& line : lines_of(hints)) {
    if (line.starts_with("## ")) {
      ++current;
      wanted = true;
    } else if (line.starts_with("### ")) {
      const std::string promise = property_name(line.substr(4));
      wanted = std::any_of(promises.begin(), promises.end(), [&](const std::string& name) {
        return name == promise || name == promise + "_bonus";
      });
    }
    if (current == tier && wanted) text += line + "\n";
  }
  return text;
}

std::string hint(const Config& config, const std::string& slug, int tier) {
  const std::string path = config.root + "/grader/tasks/" + slug + "/hints.md";
  if (!fs::exists(path)) throw pt::Error("there are no hints for '" + slug + "'");
  std::vector<std::string> memory = recall(config, slug);
  const int given = std::clamp(std::atoi(memory[0].c_str()), 0, kTiers);
  const int next = tier > 0 ? tier : std::min(given + 1, kTiers);
  const std::string text = hint_text(read_file(path), next, {memory.begin() + 1, memory.end()});
  if (text.empty()) throw pt::Error(path + fmt::format(" has no section {}", next));
  memory[0] = std::to_string(std::max(given, next));
  remember(config, slug, memory);
  return text + fmt::format("\n(hint {} of {} for {}{})\n", next, kTiers, slug,
                            next < kTiers ? "; ask again for the next" : "");
}

void remember_failures(const Config& config, const Results& results) {
  for (const TaskResult& task : results.tasks) {
    std::vector<std::string> memory{recall(config, task.slug)[0]};
    if (task.state == State::pass) memory[0] = "0";
    for (const PromiseResult& promise : task.promises) {
      if (!promise.held && !promise.failures.empty()) memory.push_back(promise.name);
    }
    remember(config, task.slug, memory);
  }
}

}  // namespace grader
