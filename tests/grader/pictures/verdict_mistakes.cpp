// Finds the pictures that see each mistake. Judges each mistake of grader/tasks/*/mistakes.txt, and
// each solution in grader/tasks/*/{right,noisy}/, with the reference's other tasks, built and
// judged like a submission, on the recipes that judge its task. Each verdict is a line of a CSV. A
// known pair is not judged again, so the program can be stopped and started at any time. On an
// adaptive recipe it adds the reference with other survival probabilities, which is right but has
// another variance.
#include "grader/base/parallel.h"
#include "grader/base/sha256.h"
#include "grader/pictures/recipes/recipes.h"
#include "grader/service/judging/alone.h"
#include "grader/service/judging/picture_trial.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/fixtures/task_folder.h"
#include "tests/grader/pictures/mistake_rows.h"

#include <cstdio>
#include <fstream>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace grader;
using namespace grader::tests;
namespace fs = std::filesystem;

constexpr int kRounds = 3;
// Milliseconds: twice a submission's limit, because several are judged at a time.
constexpr int kCallLimit = 4000;

struct Options {
  std::string out = "build/verdict_mistakes.csv";
  std::vector<std::string> tasks;
  std::vector<std::string> recipes;  // empty: all
  int threads = 2;
  int rounds = kRounds;
  bool tables_only = false;
};

// One file and the findings to make on it.
struct Job {
  const build::TaskConfig* task;
  std::string kind;
  std::string name;
  std::string text;
  std::vector<const pictures::Recipe*> recipes;
};

MistakeRow empty_row(const Job& job, const pictures::Recipe& recipe) {
  MistakeRow row;
  row.task = job.task->slug;
  row.kind = job.kind;
  row.solution = job.name;
  row.content = base::sha256(job.text).substr(0, 12);
  row.recipe = recipe.name;
  return row;
}

std::string golden_rates(const build::Config& config, const pictures::Recipe& recipe) {
  return config.root + "/golden/" + recipe.name + "_rates.json";
}

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::count(all.begin(), all.end(), one) > 0;
}

// The solutions that are not known yet, with their missing recipes.
std::vector<Job> find_jobs(const build::Config& config, const Options& options,
                           const std::vector<pictures::Recipe>& recipes,
                           const std::set<std::string>& known) {
  std::vector<Job> jobs;
  for (const build::TaskConfig& task : config.tasks) {
    if (!options.tasks.empty() && !contains(options.tasks, task.slug)) continue;
    for (const char* kind : {"wrong", "right", "noisy"}) {
      for (const KeptSolution& kept : kept_solutions(config.root, task.slug, kind)) {
        Job job{&task, kind, kept.name, pt::read_file(kept.file), {}};
        for (const pictures::Recipe& recipe : recipes) {
          const auto& judged = recipe.tasks;
          const bool wanted = options.recipes.empty() || contains(options.recipes, recipe.name);
          if (wanted && contains(judged, task.slug) &&
              !known.contains(empty_row(job, recipe).key())) {
            job.recipes.push_back(&recipe);
          }
        }
        if (!job.recipes.empty()) jobs.push_back(job);
      }
    }
  }
  return jobs;
}

// The CSV, to which several threads add lines.
class Book {
 public:
  explicit Book(const std::string& path) : file_(path, std::ios::app) {
    if (!file_) throw pt::Error(path + ": cannot be written; choose another --out");
  }

  void add(const MistakeRow& row) {
    const std::lock_guard lock(mutex_);
    file_ << to_line(row) + '\n' << std::flush;
  }

  void ended(std::size_t all) {
    const std::lock_guard lock(mutex_);
    std::fprintf(stderr, "\r%zu of %zu solutions", ++ended_, all);
  }

 private:
  std::ofstream file_;
  std::mutex mutex_;
  std::size_t ended_ = 0;
};

MistakeRow row_of(const Job& job, const pictures::Recipe& recipe,
                  const results::PictureResult& result, int rounds, const build::Config& config) {
  MistakeRow row = empty_row(job, recipe);
  row.most_rounds = rounds;
  row.state = name(result.state);
  row.rounds = result.rounds;
  row.noise = result.noise;
  row.seconds = result.seconds;
  if (!result.counts.empty()) row.map = figures_of(result.counts, golden_rates(config, recipe));
  row.text = result.text;
  return row;
}

// Judges in its own folder and removes it, because three hundred workers fill a disk.
void judge(build::Config config, const judging::GradeRequest& request, const Options& options,
           const Job& job, Book& book) {
  config.work += "/mistakes/" + job.task->slug + "." + job.kind + "." + job.name;
  const build::Builder builder(config, request.isolation.tier, request.compile_limit);
  judging::Judged judged;
  judged.config = job.task;
  judged.object = builder.compile(*job.task, job.text);
  if (!judged.object.ok()) {
    throw pt::Error(job.name + " does not compile: " + judged.object.error +
                    judged.object.rejected);
  }
  const build::Built worker =
      judging::link_alone(config, builder, judged, judging::Elsewhere::reference);
  if (!worker.ok()) throw pt::Error(job.name + " does not link: " + worker.error);
  for (const pictures::Recipe* recipe : job.recipes) {
    const results::PictureResult result = judging::try_picture(
        config, builder, request,
        {*recipe, *job.task, worker, base::sha256(job.text), false, options.rounds});
    book.add(row_of(job, *recipe, result, options.rounds, config));
  }
  fs::remove_all(config.work);
}

// Runs the reference in this program, not in a worker, on the coarse adaptive recipe.
void judge_survivals(const std::vector<pictures::Recipe>& recipes,
                     const std::set<std::string>& known, Book& book) {
  const std::vector<double> survivals{0.7, 0.65, 0.6, 0.5, 0.8};
  std::vector<MistakeRow> rows;
  for (const double survival : survivals) {
    MistakeRow row;
    row.task = "adaptive_pixel";
    row.kind = "reference";
    row.solution = fmt::format("survival_{:g}", survival);
    row.recipe = "adaptive_coarse";
    row.most_rounds = kRounds;
    row.state = "none";  // only its map is judged
    if (!known.contains(row.key())) rows.push_back(row);
  }
  if (rows.size() != survivals.size()) return;
  const std::vector<MapFigures> maps =
      figures_of_survivals(pictures::find(recipes, "adaptive_coarse"), survivals);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].map = maps[i];
    book.add(rows[i]);
  }
}

void print_tables(const Options& options, const std::vector<pictures::Recipe>& recipes) {
  const std::vector<MistakeRow> rows = read_rows(options.out);
  fmt::print("{}\n", table_of_mistakes(rows));
  for (const pictures::Recipe& recipe : recipes) {
    if (recipe.adaptive) fmt::print("{}\n", table_of_maps(rows, recipe.name));
  }
}

int run(const Options& options) {
  const build::Config config = build::load_config(build::default_config_path());
  const std::vector<pictures::Recipe> recipes =
      pictures::load_recipes(config.root + "/scenes/recipes.json");
  for (const std::string& task : options.tasks) judging::tasks_meant(config, task);
  for (const std::string& recipe : options.recipes) pictures::find(recipes, recipe);
  if (!options.tables_only) {
    std::set<std::string> known;
    // A picture that passes does so with any number of rounds.
    for (const MistakeRow& row : read_rows(options.out)) {
      if (row.state == "pass" || row.most_rounds >= options.rounds) known.insert(row.key());
    }
    judging::GradeRequest request;
    request.call_limit = kCallLimit;
    request.isolation = sandbox::probe_isolation(config.root, config.work);
    const std::vector<Job> jobs = find_jobs(config, options, recipes, known);
    Book book(options.out);
    base::for_each(jobs.size(), options.threads, [&](std::size_t i) {
      judge(config, request, options, jobs[i], book);
      book.ended(jobs.size());
    });
    if (options.tasks.empty()) judge_survivals(recipes, known, book);
    std::fprintf(stderr, "\n");
  }
  print_tables(options, recipes);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Which pictures see which wrong solutions"};
  app.add_option("task", options.tasks, "Tasks; default: all");
  app.add_option("--recipe", options.recipes, "Recipes; default: all");
  app.add_option("--threads", options.threads, "At a time")->check(CLI::Range(1, 256));
  app.add_option(
      "--out", options.out,
      "The CSV: task, kind, solution, content, recipe, most rounds, state, rounds, noise, "
      "seconds; "
      "of a sample map whether it passes, ratio, a, b, correlation; text");
  app.add_option("--rounds", options.rounds,
                 "At most; a later call with more goes on with pictures that had a failing cell")
      ->check(CLI::Range(1, kRounds));
  app.add_flag("--tables", options.tables_only, "Judge nothing: print the tables of what is known");
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
