// grade_examples: judges a learner's examples of tasks, and the learner's own tasks by them. Exit status 0 if all examples that check
// something are valid and the learner's own functions pass them, 1 if not, 2 if there is nothing to judge.
#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/examples/report.h"
#include "grader/service/build/builder.h"
#include "grader/service/build/cache.h"
#include "grader/service/sandbox/probe.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace {

namespace fs = std::filesystem;
using namespace grader;

// More than any file needs.
constexpr int kCompileSeconds = 60;

struct Options {
  std::vector<std::string> tasks;
  std::string submission = "student";
  std::string config;
  std::string caught;  // a file for the names of the mistakes that are caught
};

// All that judges: two builders, because a program of examples has another main program than a worker.
struct Judge {
  build::Config config, runs;
  std::string programs;  // the folder of the programs
  sandbox::Isolation isolation;
  build::Builder builder, linker;

  Judge(const build::Config& own, const build::Config& of_examples, const std::string& folder)
      : config(own),
        runs(of_examples),
        programs(folder),
        isolation(sandbox::probe_isolation(config.root, config.work)),
        builder(config, isolation.tier, kCompileSeconds),
        linker(runs, isolation.tier, kCompileSeconds) {}
};

// The file of CMake about programs of examples: their framework, and the objects of all solutions of each task.
nlohmann::json examples_json(const fs::path& folder) {
  return nlohmann::json::parse(pt::read_file(folder / "examples.json"));
}

build::Config config_of_examples(build::Config config, const fs::path& folder) {
  config.framework = examples_json(folder).at("framework").get<build::Paths>();
  config.recording.clear();
  return config;
}

// Links the examples with these objects of their task, and with the reference of all others.
build::Built link(const Judge& judge, const std::string& slug, const build::Paths& own,
                  const build::Built& examples) {
  build::Paths objects = own;
  std::string key = examples.key;
  for (const std::string& path : own) key += build::content_stamp(path, judge.builder.cache());
  objects.push_back(examples.path);
  const auto add = [&](const build::Paths& paths) {
    for (const std::string& path : paths) {
      objects.push_back(path);
      key += build::content_stamp(path, judge.builder.cache());
    }
  };
  for (const build::TaskConfig& task : judge.config.tasks) {
    if (task.slug != slug) add(task.reference);
  }
  add(judge.config.radiance);
  return judge.linker.link(objects, base::sha256(key), false);
}

std::string problem_of(const build::Built& built) {
  return built.error.empty() ? built.rejected : built.error;
}

// Judges the learner's own function by the valid examples. Returns whether it passes, or is not written.
bool judge_own(const Judge& judge, const build::TaskConfig& task, const Options& options,
               const build::Built& examples, const examples::Verdicts& verdicts) {
  const base::Submitted file = base::read_submitted(options.submission, task.part, task.slug);
  if (!file.present || !file.rejected.empty() || verdicts.valid().empty()) return true;
  const build::Built own = judge.builder.compile(task, file.text);
  const build::Built program = own.ok() ? link(judge, task.slug, {own.path}, examples) : own;
  if (!program.ok()) {
    fmt::print("\nYour own {} does not compile: ./run grade {} shows why.\n", task.slug, task.slug);
    return false;
  }
  const examples::Run run =
      examples::run_examples({program.path, judge.isolation.tier}, {}, verdicts.valid());
  fmt::print("{}", own_text(verdicts, run, task.slug));
  const auto passes = [&](std::size_t i) {
    return i < run.outcomes.size() && run.outcomes[i].holds();
  };
  return std::ranges::count(run.todo, task.slug) > 0 ||
         std::ranges::all_of(verdicts.valid(), passes);
}

std::string names_of_caught(const examples::Verdicts& verdicts) {
  std::string names;
  for (std::size_t m = 0; m < verdicts.mistakes.size(); ++m) {
    if (verdicts.caught[m]) names += verdicts.mistakes[m].name + '\n';
  }
  return names;
}

// Returns whether all is right.
bool judge_task(const Judge& judge, const build::TaskConfig& task, const Options& options) {
  const std::string name = task.slug + ".examples";
  const base::Submitted file = base::read_submitted(options.submission, task.part, name);
  const std::string path = fmt::format("{}/{}/{}.cpp", options.submission, task.part, name);
  if (!file.rejected.empty()) throw pt::Error(path + ": " + file.rejected);
  if (!file.present) throw pt::Error(path + " is missing: write your examples there");
  const build::Built examples = judge.linker.compile_examples(task, file.text);
  const auto objects =
      examples_json(judge.programs).at("solutions").at(task.slug).get<build::Paths>();
  if (objects.empty())
    throw pt::Error(
        "the solutions in this folder were compiled for another machine: there are none to judge "
        "examples by");
  const build::Built program = examples.ok() ? link(judge, task.slug, objects, examples) : examples;
  if (!program.ok()) {
    fmt::print("{} does not compile:\n{}\n", path, problem_of(program));
    return false;
  }
  auto solutions =
      mistakes::read_solutions(fmt::format("{}/solutions.{}.txt", judge.programs, task.slug));
  mistakes::mark_ordinary(solutions, fmt::format("{}/ordinary.{}.txt", judge.programs, task.slug));
  const auto threads = static_cast<int>(std::thread::hardware_concurrency());
  const examples::Verdicts verdicts =
      examples::judge({program.path, judge.isolation.tier}, solutions, threads);
  if (verdicts.examples.empty()) {
    fmt::print("{}: {}\n", path,
               verdicts.fault.empty() ? "it has no EXAMPLE"
                                      : "it ends before its first example: " + verdicts.fault);
    return false;
  }
  if (!options.caught.empty()) {
    if (verdicts.valid().size() < verdicts.examples.size())
      throw pt::Error(path + ": a right solution does not agree: " + to_text(verdicts, {}));
    pt::write_file(options.caught, names_of_caught(verdicts));
    return true;
  }
  fmt::print("{}", to_text(verdicts, examples::texts_of(judge.config.root, task.slug)));
  std::fflush(stdout);
  const bool own = judge_own(judge, task, options, examples, verdicts);
  const auto is_fine = [](const examples::Judged& example) {
    return example.verdict == examples::Verdict::valid ||
           example.verdict == examples::Verdict::empty;
  };
  return own && std::ranges::all_of(verdicts.examples, is_fine);
}

int run(const Options& options) {
  const std::string path = options.config.empty() ? build::default_config_path() : options.config;
  const build::Config config = build::load_config(path);
  const fs::path folder = fs::absolute(path).parent_path();
  std::vector<const build::TaskConfig*> tasks;
  for (const std::string& word : options.tasks) {
    const auto found = std::ranges::find_if(config.tasks, [&](const build::TaskConfig& task) {
      return word == task.slug || word == task.number;
    });
    if (found == config.tasks.end())
      throw pt::Error(fmt::format("'{}' is not a task; choose one of those in pt/tasks/", word));
    tasks.push_back(&*found);
  }
  const Judge judge(config, config_of_examples(config, folder), folder);
  bool right = true;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (i > 0) fmt::print("\n\n");
    right = judge_task(judge, *tasks[i], options) && right;
  }
  return right ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{
      "Judges your examples of a task by right and wrong solutions, and your own task by them",
      "./run examples"};
  app.add_option("task", options.tasks, "hit_sphere, or 1.4")->required();
  app.add_option("--submission", options.submission,
                 "the folder with <task>.examples.cpp, as the tree of student/")
      ->check(CLI::ExistingDirectory);
  app.add_option("--config", options.config, "what CMake wrote (grade.json)");
  app.add_option("--caught", options.caught)->group("");  // for the build (cmake/grade_json.cmake)
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
