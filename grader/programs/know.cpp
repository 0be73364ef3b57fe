// know: runs the battery of a task on every known mistake, and writes the answers as known.<slug>.json, from which `grade`
// names the mistake of a submission. The build runs it (cmake/mistakes.cmake), so that the answers are never older than
// the mistakes.
#include "grader/base/files.h"
#include "grader/base/parallel.h"
#include "grader/mistakes/known.h"
#include "grader/mistakes/naming.h"
#include "grader/mistakes/solutions.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/box.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <filesystem>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

namespace fs = std::filesystem;
using namespace grader;

struct Options {
  std::string graded;     // the program that runs the battery: graded.<slug>
  std::string reference;  // a worker with the reference
  std::string all;        // a worker that acts as the solution by whose number it is called
  std::string solutions;  // solutions.<slug>.txt
  std::string made;       // the folder of the mistakes' files
  std::string out;
};

// The answers of all submissions are compared with these answers, so they use more draws.
constexpr int kSeed = 20240607, kDraws = 2;

mistakes::Answers ask(const Options& options, const fs::path& worker) {
  const std::string path = worker.string() + ".json";
  const std::vector<std::string> command{options.graded,        "--worker", worker.string(),
                                         "--battery",           path,       "--seed",
                                         std::to_string(kSeed), "--draws",  std::to_string(kDraws)};
  const process::CommandResult result = process::run_command(
      {command, sandbox::judges_environment(), {}, "", {}}, process::kProgramTime);
  if (!result.ok()) throw pt::Error(worker.string() + ": " + process::fault_of(result));
  return mistakes::answers_from_json(pt::read_file(path));
}

// The mistakes that are named: not guards, which have no sentence, nor those that break a bonus promise, which pass.
std::vector<mistakes::Fingerprint> mistakes_in(const fs::path& made) {
  std::vector<mistakes::Fingerprint> all;
  for (const auto& entry : fs::directory_iterator(made)) {
    const fs::path file = entry.path() / made.filename().replace_extension(".cpp");
    mistakes::Fingerprint print = mistakes::described(entry.path().filename(), pt::read_file(file));
    if (!print.sentence.empty() && !print.breaks.ends_with("_bonus"))
      all.push_back(std::move(print));
  }
  std::ranges::sort(all, {}, &mistakes::Fingerprint::name);
  return all;
}

int run(const Options& options) {
  const fs::path folder = pt::temporary_name(options.out) + ".workers";
  fs::create_directories(folder);
  const auto ask_named = [&](const std::string& program, const std::string& name) {
    fs::create_symlink(fs::absolute(program), folder / name);
    return ask(options, folder / name);
  };
  const auto threads = static_cast<int>(std::thread::hardware_concurrency());
  const std::vector<mistakes::Solution> solutions = mistakes::read_solutions(options.solutions);
  const auto ask_number = [&](std::size_t number) {
    return ask_named(options.all, std::to_string(number));
  };
  const auto ask_mistake = [&](const std::string& name) {
    const auto found = std::ranges::find(solutions, name, &mistakes::Solution::name);
    if (found == solutions.end()) throw pt::Error(options.solutions + " does not name " + name);
    return ask_number(static_cast<std::size_t>(found - solutions.begin()));
  };
  mistakes::KnownTask known{ask_named(options.reference, "reference"), mistakes_in(options.made)};
  base::for_each(known.mistakes.size(), threads, [&](std::size_t i) {
    known.mistakes[i].answers = ask_mistake(known.mistakes[i].name);
  });
  std::vector<std::size_t> rights;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    if (solutions[i].is_right()) rights.push_back(i);
  }
  std::vector<mistakes::Answers> right(rights.size());
  base::for_each(right.size(), threads, [&](std::size_t i) { right[i] = ask_number(rights[i]); });
  std::erase_if(known.mistakes, [&](const mistakes::Fingerprint& print) {
    return std::ranges::any_of(right,
                               [&](const auto& answers) { return agree(print.answers, answers); });
  });
  pt::write_file(options.out, mistakes::to_json(known));
  fs::remove_all(folder);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Keeps the answers of the known mistakes of a task"};
  app.add_option("--graded", options.graded, "the program that runs the battery")->required();
  app.add_option("--reference", options.reference, "a worker with the reference")->required();
  app.add_option("--all", options.all, "a worker with all mistakes and right solutions")
      ->required();
  app.add_option("--solutions", options.solutions, "what each number of that worker is")
      ->required();
  app.add_option("--made", options.made, "the folder of their files")->required();
  app.add_option("--out", options.out, "the file to write")->required();
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
