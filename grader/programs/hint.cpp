// hint: gives the next hint for a task. Exit status 0, or 2 if there is no such task or promise.
#include "grader/base/wrap.h"
#include "grader/report/hints.h"
#include "grader/results/promises.h"
#include "grader/tasks.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace {

using namespace grader;

struct Options {
  std::string task;
  std::vector<std::string> promise;  // its words
  std::string root, work;            // folders: of the project, and where `grade` keeps its builds
  bool first = false;
};

std::string slug_of(const std::string& word) {
  std::vector<std::string> slugs;
  for (const Task& task : tasks()) {
    if (word == task.slug || word == task.number) return task.slug;
    slugs.push_back(task.slug);
  }
  throw pt::Error(
      fmt::format("'{}' is not a task; choose one of {}", word, fmt::join(slugs, ", ")));
}

// Finds the promise by its words, or by the name of its property.
results::Promise find_promise(const std::vector<results::Promise>& promises,
                              const std::string& slug, const std::string& words) {
  const std::string name = results::property_name(words);
  std::vector<std::string> titles;
  for (const results::Promise& promise : promises) {
    if (name == promise.name || name + "_bonus" == promise.name) return promise;
    titles.push_back(promise.title);
  }
  throw pt::Error(fmt::format("{} does not promise '{}'; choose one of: {}", slug, words,
                              fmt::join(titles, "; ")));
}

// The first of these names that is a promise of the contract: a clone of the course has others too, and no hints for them.
std::string first_known(const std::vector<results::Promise>& promises,
                        const std::vector<std::string>& names) {
  const auto known = std::ranges::find_if(names, [&](const std::string& name) {
    return std::ranges::count(promises, name, &results::Promise::name) > 0;
  });
  return known == names.end() ? "" : *known;
}

// Wraps paragraphs again: the files are wider than many terminals.
std::string paragraphs(const std::string& text) {
  std::string all, paragraph;
  for (const std::string& line : base::lines_of(text + "\n\n")) {
    paragraph += line + ' ';
    if (!line.empty()) continue;
    for (const std::string& wrapped : base::wrap(paragraph, 80)) all += wrapped + '\n';
    if (!base::wrap(paragraph, 80).empty()) all += '\n';
    paragraph.clear();
  }
  return all;
}

int run(const Options& options) {
  const std::string slug = slug_of(options.task);
  const std::string path = options.root + "/grader/tasks/" + slug + "/hints.md";
  const report::Hints hints = report::parse_hints(pt::read_file(path), path);
  const auto promises =
      results::promises_of(pt::read_file(options.root + "/pt/tasks/" + slug + ".h"));

  report::Memory memory = report::recall(options.work, slug);
  std::string asked = fmt::format("{}", fmt::join(options.promise, " "));
  if (asked.empty()) asked = first_known(promises, memory.fails);
  const results::Promise about_it =
      asked.empty() ? results::Promise{} : find_promise(promises, slug, asked);

  int& step = memory.given[about_it.name];
  if (options.first) step = 0;
  const std::string name = slug + (asked.empty() ? "" : " " + about_it.title);
  if (step < 0 || step >= static_cast<int>(report::kHintSteps.size())) {
    fmt::print("There are no more hints for \"{}\"; ./run hint {} --first starts again.\n", name,
               slug);
    return 0;
  }
  const auto index = static_cast<std::size_t>(step++);
  fmt::print("{}\n{} ({} of {}):\n\n{}", name, report::kHintSteps[index], step,
             report::kHintSteps.size(), paragraphs(report::about(hints[index], about_it.name)));
  report::remember(options.work, slug, memory);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Gives the next hint for a task: a question, a direction, the usual mistake",
               "./run hint"};
  app.add_option("task", options.task, "hit_triangle, or 1.3")->required();
  app.add_option("promise", options.promise,
                 "what the hint is about (default: what failed when the task was last graded)");
  app.add_flag("--first", options.first, "start again with the first hint");
  app.add_option("--root", options.root, "Given by ./run")->required()->group("");
  app.add_option("--work", options.work, "Given by ./run")->required()->group("");
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
