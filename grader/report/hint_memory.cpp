#include "grader/report/hint_memory.h"

#include "grader/base/wrap.h"
#include "grader/results/order.h"
#include "pt/file.h"

#include <filesystem>
#include <sstream>

#include <fmt/format.h>

namespace grader::report {

namespace {

namespace fs = std::filesystem;

std::string path_of(const std::string& work, const std::string& slug) {
  return work + "/hints/" + slug;
}

}  // namespace

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
