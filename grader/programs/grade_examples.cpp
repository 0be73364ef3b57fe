// grade_examples: judges a learner's examples of tasks, and the learner's own tasks by them. Exit status 0 if all examples that check
// something are valid and the learner's own functions pass them, 1 if not, 2 if there is nothing to judge. In the hunt it is 0 if the
// wrong solution was found.
#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/examples/hunt.h"
#include "grader/examples/report.h"
#include "grader/service/build/builder.h"
#include "grader/service/build/cache.h"
#include "grader/service/sandbox/probe.h"
#include "grader/tasks.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

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
  std::string counts;  // a file for the counts of what is caught, as JSON
  bool hunt = false, show = false;
  std::optional<std::uint64_t> seed;  // chooses the wrong solution to hunt
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

// Links the examples with these objects of their task, and with the reference of all others, or a mock where the judge has one too: the
// mock of diffuse_bsdf has two densities, so that a path shows whether it divides by the right one.
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
  const std::vector<std::string>& mocks = task_of(slug).mocks;
  for (const build::TaskConfig& task : judge.config.tasks) {
    if (task.slug == slug) continue;
    const bool is_mock = std::ranges::count(mocks, task.slug) > 0;
    add(is_mock ? judge.config.callbacks.at(task.slug) : task.reference);
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

// A learner's examples of a task, linked with all of its solutions.
struct Linked {
  std::string path;  // of the file
  build::Built examples, program;
  std::vector<mistakes::Solution> solutions;
};

Linked link_examples(const Judge& judge, const build::TaskConfig& task, const Options& options) {
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
  auto solutions =
      mistakes::read_solutions(fmt::format("{}/solutions.{}.txt", judge.programs, task.slug));
  mistakes::mark_ordinary(solutions, fmt::format("{}/ordinary.{}.txt", judge.programs, task.slug));
  return {path, examples, examples.ok() ? link(judge, task.slug, objects, examples) : examples,
          solutions};
}

// Judges the examples by all solutions, or by the right ones and one mistake. Prints why, if there is nothing to judge.
std::optional<examples::Verdicts> verdicts_on(const Judge& judge, const Linked& linked,
                                              std::optional<std::size_t> only_mistake = {}) {
  if (!linked.program.ok()) {
    fmt::print("{} does not compile:\n{}\n", linked.path, problem_of(linked.program));
    return std::nullopt;
  }
  const auto threads = static_cast<int>(std::thread::hardware_concurrency());
  examples::Verdicts verdicts = examples::judge({linked.program.path, judge.isolation.tier},
                                                linked.solutions, threads, only_mistake);
  if (!verdicts.examples.empty()) return verdicts;
  fmt::print("{}: {}\n", linked.path,
             verdicts.fault.empty() ? "it has no EXAMPLE"
                                    : "it ends before its first example: " + verdicts.fault);
  return std::nullopt;
}

// Returns whether all is right.
bool judge_task(const Judge& judge, const build::TaskConfig& task, const Options& options) {
  const Linked linked = link_examples(judge, task, options);
  const auto verdicts = verdicts_on(judge, linked);
  if (!verdicts) return false;
  if (!options.caught.empty()) {
    if (verdicts->valid().size() < verdicts->examples.size())
      throw pt::Error(linked.path + ": a right solution does not agree: " + to_text(*verdicts, {}));
    pt::write_file(options.caught, names_of_caught(*verdicts));
    return true;
  }
  fmt::print("{}", to_text(*verdicts, examples::texts_of(judge.config.root, task.slug)));
  std::fflush(stdout);
  const bool own = judge_own(judge, task, options, linked.examples, *verdicts);
  const auto is_fine = [](const examples::Judged& example) {
    return example.verdict == examples::Verdict::valid ||
           example.verdict == examples::Verdict::empty;
  };
  return own && std::ranges::all_of(verdicts->examples, is_fine);
}

// The mistakes that the examples catch, for `grade`: rows of points (grader/programs/examples_in_results.h). Empty if they cannot be judged.
nlohmann::json counts_of(const Judge& judge, const build::TaskConfig& task,
                         const Options& options) {
  nlohmann::json rows = nlohmann::json::array();
  const auto verdicts = verdicts_on(judge, link_examples(judge, task, options));
  if (!verdicts) return rows;
  const auto promises = examples::texts_of(judge.config.root, task.slug).promises;
  for (const auto& [promise, caught, all] : shares(*verdicts, promises))
    rows.push_back(
        {{"promise", promise.name}, {"title", promise.title}, {"caught", caught}, {"all", all}});
  return rows;
}

// Shows the wrong solution that was found, and asks for its line. On a terminal a key answers; elsewhere the option --show does.
void show_found(const Judge& judge, const build::TaskConfig& task, const std::string& name,
                const Options& options) {
  const std::string& root = judge.config.root;
  const examples::Found found = examples::found(root, judge.programs, task.slug, name);
  const bool has_source = !found.source.empty();
  std::set<std::string> right;
  if (has_source) right = examples::lines_of_right(root, task.part, task.slug);
  const bool asks = has_source && !options.show;
  if (asks) {
    fmt::print("\n{}\nWhich line is wrong? ", examples::numbered(found.source, right, false));
    if (isatty(STDIN_FILENO) == 0) {
      fmt::print("`./run hunt {} --show` marks it.\n", task.slug);
      return;
    }
    fmt::print("Press the Enter key to see it. ");
    std::fflush(stdout);
    while (true) {
      const int key = std::getchar();
      if (key == '\n' || key == EOF) break;
    }
  }
  if (has_source) fmt::print("\n{}", examples::numbered(found.source, right, true));
  fmt::print("\n{}\n", found.mistake.sentence);
}

// Returns whether the examples find the wrong solution of this learner.
bool hunt_task(const Judge& judge, const build::TaskConfig& task, const Options& options) {
  const Linked linked = link_examples(judge, task, options);
  const std::uint64_t seed = options.seed.value_or(examples::seed_of_learner());
  const examples::Quarry quarry = examples::choose(linked.solutions, task.slug, seed);
  const auto verdicts = verdicts_on(judge, linked, quarry.number);
  if (!verdicts) return false;
  fmt::print("{}: the hunt for one of {} wrong solutions, by --seed {}\n\n{}", task.slug,
             quarry.one_of, seed, examples::rows_text(*verdicts));
  const auto caught = verdicts->caught.front();
  if (!caught) {
    fmt::print(
        "\nThe wrong solution agrees with all valid examples. Find an input at which it "
        "is wrong: write another example.\n");
    return false;
  }
  const examples::Run run = examples::run_examples({linked.program.path, judge.isolation.tier},
                                                   quarry.number, std::vector{*caught});
  fmt::print("\nFound: it fails \"{}\", because {}.\n", verdicts->examples[*caught].name,
             run.outcomes[*caught].words);
  show_found(judge, task, verdicts->mistakes.front().name, options);
  return true;
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
  if (!options.counts.empty()) {
    nlohmann::json counts = nlohmann::json::object();
    for (const build::TaskConfig* task : tasks)
      counts[task->slug] = counts_of(judge, *task, options);
    pt::write_file(options.counts, counts.dump(1) + '\n');
    return 0;
  }
  bool right = true;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (i > 0) fmt::print("\n\n");
    const auto judged = options.hunt ? hunt_task : judge_task;
    right = judged(judge, *tasks[i], options) && right;
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
  app.add_flag("--hunt", options.hunt,
               "look for one wrong solution, which is chosen for you; ./run hunt does this");
  app.add_option("--seed", options.seed, "with --hunt: a number that chooses another one");
  app.add_flag("--show", options.show, "with --hunt: mark the wrong line of the one that is found");
  app.add_option("--config", options.config, "what CMake wrote (grade.json)");
  app.add_option("--caught", options.caught)->group("");  // for the build (cmake/grade_json.cmake)
  app.add_option("--counts", options.counts)->group("");  // for grade
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
