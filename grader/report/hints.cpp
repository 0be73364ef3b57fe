#include "grader/report/hints.h"

#include "grader/base/wrap.h"
#include "grader/results/order.h"
#include "grader/results/promises.h"
#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>
#include <sstream>

#include <fmt/format.h>

namespace grader::report {

namespace {

// The text that the lines after the latest heading belong to, and where that heading is.
struct Section {
  std::string* text = nullptr;
  std::size_t line = 0;
};

[[noreturn]] void fail(const std::string& path, std::size_t line, const std::string& what) {
  throw pt::Error(fmt::format("{}:{}: {}", path, line, what));
}

void end(const Section& section, const std::string& path) {
  if (section.text == nullptr) return;
  std::string& text = *section.text;
  text.erase(0, text.find_first_not_of('\n'));
  text.erase(text.find_last_not_of('\n') + 1);
  if (text.empty()) fail(path, section.line, "this heading has no text below it; write some");
}

namespace fs = std::filesystem;

std::string path_of(const std::string& work, const std::string& slug) {
  return work + "/hints/" + slug;
}

}  // namespace

Hints parse_hints(const std::string& text, const std::string& path) {
  Hints hints;
  Section section;
  std::size_t steps = 0, number = 0;
  for (const std::string& line : base::lines_of(text)) {
    ++number;
    if (line.starts_with("## ")) {
      end(section, path);
      if (steps == kHintSteps.size()) fail(path, number, "a step too many; leave it out");
      if (line.substr(3) != kHintSteps[steps]) {
        fail(path, number, fmt::format("write the heading '## {}' here", kHintSteps[steps]));
      }
      section = {&hints[steps++].general, number};
    } else if (line.starts_with("### ")) {
      if (steps == 0) fail(path, number, "a promise comes below a step; write '## Question' first");
      end(section, path);
      auto& promises = hints[steps - 1].promises;
      promises.push_back({line.substr(4), ""});
      section = {&promises.back().text, number};
    } else if (section.text != nullptr) {
      *section.text += line + '\n';
    }
  }
  end(section, path);
  if (steps < kHintSteps.size()) {
    fail(path, number, fmt::format("the step '## {}' is missing; write it", kHintSteps[steps]));
  }
  return hints;
}

const std::string& about(const HintStep& step, const std::string& promise) {
  for (const PromiseHint& hint : step.promises) {
    const std::string name = results::property_name(hint.title);
    if (promise == name || promise == name + "_bonus") return hint.text;
  }
  return step.general;
}

Memory recall(const std::string& work, const std::string& slug) {
  Memory memory;
  const std::string path = path_of(work, slug);
  if (!fs::exists(path)) return memory;
  for (const std::string& line : base::lines_of(pt::read_file(path))) {
    std::istringstream words(line);
    std::string label, promise;
    int step = 0;
    words >> label;
    if (label == "seed") words >> memory.seed;
    if (label == "fails" && words >> promise) memory.fails.push_back(promise);
    if (label == "given" && words >> step) {
      words >> promise;
      memory.given[promise] = step;
    }
  }
  return memory;
}

void remember(const std::string& work, const std::string& slug, const Memory& memory) {
  std::string text = fmt::format("seed {}\n", memory.seed);
  for (const std::string& promise : memory.fails) text += "fails " + promise + "\n";
  for (const auto& [promise, step] : memory.given) {
    text += fmt::format("given {} {}\n", step, promise);
  }
  const std::string path = path_of(work, slug);
  fs::create_directories(fs::path(path).parent_path());
  pt::write_file(path, text);
}

void remember_failures(const std::string& work, const results::Results& results) {
  for (const results::TaskResult& task : results.tasks) {
    Memory memory = recall(work, task.slug);
    if (task.state == results::State::pass) memory.given.clear();
    memory.seed = results.seed;
    // A file that does not compile says nothing about promises: earlier failures still count.
    if (task.compiler_output.empty()) memory.fails.clear();
    for (const results::PromiseResult* promise : results::by_importance(task)) {
      if (!promise->failures.empty()) memory.fails.push_back(promise->name);
    }
    remember(work, task.slug, memory);
  }
}

}  // namespace grader::report
