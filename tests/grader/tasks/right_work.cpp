// Grades right work, as much as the options say: mixtures of right variants, each variant alone, and
// the reference, with many seeds, also next to busy loops. The judge keeps its verdicts, so the program
// can be stopped and started at any time. Exit status 1: right work has failed, so the judge is wrong.
//
// After a change to a promise, a contract or a picture: nice right_work --variant-seeds 10
// --mixtures 200 --mixtures-with-pictures 40 --reference-seeds 300
// --reference-seeds-with-pictures 100, and the same with --busy 30.
#include "grader/base/files.h"
#include "grader/base/parallel.h"
#include "grader/service/judging/grade.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/sampling/sampler.h"
#include "tests/grader/service/judging/busy_loops.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

namespace {

using namespace grader;
namespace fs = std::filesystem;

// With many busy loops running, a right task takes longer by the clock, but not in its own time.
constexpr int kCallLimit = 2000;

struct Options {
  int mixtures = 0, mixtures_with_pictures = 0;
  int variant_seeds = 0;
  int reference_seeds = 0, reference_seeds_with_pictures = 0;
  std::uint64_t first_seed = 1;
  int busy = 0;
  int threads = 2;
  std::vector<std::string> tasks;  // variants of these; empty: of all
};

// One submission and how it is graded.
struct RightJob {
  std::string kind;                          // "mixture", "variant" or "reference"
  std::string name;                          // "17", "hit_sphere.half_b", "reference"
  std::map<std::string, std::string> files;  // path of each task's file by slug
  std::vector<std::string> asked;            // the slugs that are judged
  std::uint64_t seed = 1;
  bool pictures = false;
};

// The candidate files for each task, in alphabetical order: the reference's file, then the files in
// grader/tasks/<slug>/right.
using Choices = std::map<std::string, std::vector<fs::path>>;

Choices right_choices(const build::Config& config) {
  Choices choices;
  for (const build::TaskConfig& task : config.tasks) {
    const fs::path reference = fs::path(config.root) / "reference" / task.file();
    if (!fs::exists(reference)) {
      throw pt::Error(reference.string() + " is missing: the learners' edition cannot do this");
    }
    choices[task.slug] = {reference};
    const auto variants =
        base::sources_in(fs::path(config.root) / "grader/tasks" / task.slug / "right");
    choices[task.slug].insert(choices[task.slug].end(), variants.begin(), variants.end());
  }
  return choices;
}

RightJob all_reference(const Choices& choices) {
  RightJob job;
  for (const auto& [slug, files] : choices) job.files[slug] = files.front();
  return job;
}

RightJob reference_job(const Choices& choices, std::uint64_t seed) {
  RightJob job = all_reference(choices);
  job.kind = job.name = "reference";
  for (const auto& each : choices) job.asked.push_back(each.first);
  job.seed = seed;
  return job;
}

std::vector<RightJob> variant_jobs(const Choices& choices, const std::vector<std::string>& tasks,
                                   std::uint64_t seed) {
  std::vector<RightJob> jobs;
  for (const auto& [slug, files] : choices) {
    if (!tasks.empty() && std::ranges::find(tasks, slug) == tasks.end()) continue;
    for (std::size_t i = 1; i < files.size(); ++i) {
      RightJob job = all_reference(choices);
      job.kind = "variant";
      job.name = slug + "." + files[i].stem().string();
      job.files[slug] = files[i];
      job.asked = {slug};
      job.seed = seed;
      jobs.push_back(job);
    }
  }
  return jobs;
}

// All files of a task are equally likely. A number means the same mixture until a file is added.
RightJob mixture_job(const Choices& choices, std::uint64_t number) {
  RightJob job;
  job.kind = "mixture";
  job.name = std::to_string(number);
  job.seed = 1000 + number;
  pt::Sampler sampler(job.seed);
  for (const auto& [slug, files] : choices) {
    const double place = sampler.next_1d() * static_cast<double>(files.size());
    job.files[slug] = files[static_cast<std::size_t>(place)];
    job.asked.push_back(slug);
  }
  return job;
}

// Cheap jobs come first, and some of every kind early.
std::vector<RightJob> find_jobs(const build::Config& config, const Options& options) {
  const Choices choices = right_choices(config);
  std::vector<RightJob> jobs;
  const auto seed_of = [&](int i) { return options.first_seed + i; };
  for (int i = 0; i < options.variant_seeds; ++i) {
    for (RightJob& job : variant_jobs(choices, options.tasks, seed_of(i)))
      jobs.push_back(std::move(job));
  }
  for (int i = 0; i < std::max(options.mixtures, options.mixtures_with_pictures); ++i) {
    jobs.push_back(mixture_job(choices, options.first_seed + i));
    jobs.back().pictures = i < options.mixtures_with_pictures;
  }
  const int references = std::max(options.reference_seeds, options.reference_seeds_with_pictures);
  for (int i = 0; i < references; ++i) {
    jobs.push_back(reference_job(choices, seed_of(i)));
    jobs.back().pictures = i < options.reference_seeds_with_pictures;
  }
  return jobs;
}

// A submission may be twelve files without folders.
class Folder {
 public:
  Folder(const std::string& path, const RightJob& job) : path_(path) {
    fs::create_directories(path_);
    for (const auto& [slug, file] : job.files) {
      fs::copy_file(file, path_ / (slug + ".cpp"), fs::copy_options::overwrite_existing);
    }
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

 private:
  fs::path path_;
};

std::string faults_of(const results::TaskResult& task) {
  std::string text = fmt::format("{}: {}", task.slug, name(task.state));
  if (!task.reason.empty()) text += ", " + task.reason;
  for (const results::PromiseResult& promise : task.promises) {
    if (promise.held || promise.bonus) continue;
    text += ", " + promise.name;
    for (const results::Failure& failure : promise.failures) {
      text += fmt::format(" ({} got {} expected {})", failure.what, failure.got, failure.expected);
    }
  }
  for (const results::PictureResult& picture : task.pictures) {
    if (picture.state != results::State::pass)
      text += ", picture " + picture.recipe + " " + picture.text;
  }
  return text;
}

// Names the tasks of which the job has another solution than the reference, each with its file, on a line.
std::string files_of(const RightJob& job) {
  std::string text;
  for (const auto& [slug, file] : job.files) {
    if (fs::path(file).stem() == slug) continue;
    text += fmt::format("\n  {}: {}", slug, fs::path(file).stem().string());
  }
  return text;
}

// Grades the job in a temporary folder below config.work. Returns the faults; none if it passed.
std::string grade_right(const build::Config& config, const sandbox::Isolation& isolation,
                        const RightJob& job) {
  const std::string path = pt::temporary_name(
      fmt::format("{}/right/{}.{}.{}", config.work, job.kind, job.name, job.seed));
  const Folder folder(path, job);
  judging::GradeRequest request;
  request.submission = path;
  request.asked = job.asked;
  request.seed = job.seed;
  request.threads = 1;
  request.call_limit = kCallLimit;
  request.pictures = job.pictures;
  request.isolation = isolation;
  const results::Results results = judging::grade(config, request, [](const results::Results&) {});
  if (results::passes(results)) return "";
  std::string faults;
  for (const results::TaskResult& task : results.tasks) {
    if (task.state == results::State::pass) continue;
    faults += (faults.empty() ? "" : "; ") + faults_of(task);
  }
  return faults.empty() ? "it does not pass" : faults;
}

// The verdicts by kind, for the last lines.
struct Count {
  int graded = 0, failed = 0;
};

int run(const Options& options) {
  build::Config config = build::load_config(build::default_config_path());
  // Verdicts in the judge's cache say nothing about a busy machine.
  if (options.busy > 0) config.work += "/right-busy-" + std::to_string(getpid());
  fs::create_directories(config.work);
  const sandbox::Isolation isolation = sandbox::probe_isolation(config.root, config.work);
  const std::vector<RightJob> jobs = find_jobs(config, options);
  if (jobs.empty()) throw pt::Error("nothing was asked for: see right_work --help");

  std::map<std::string, Count> counts;
  std::size_t ended = 0, failed = 0;
  {
    const tests::BusyLoops loops(options.busy);
    std::mutex writing;
    base::for_each(jobs.size(), options.threads, [&](std::size_t i) {
      const RightJob& job = jobs[i];
      const std::string faults = grade_right(config, isolation, job);
      const std::lock_guard lock(writing);
      Count& count = counts[job.kind + (job.pictures ? " with pictures" : " by properties")];
      ++count.graded;
      if (!faults.empty()) {
        ++count.failed;
        ++failed;
        fmt::print("{} {}, seed {}: {}{}\n", job.kind, job.name, job.seed, faults, files_of(job));
        std::fflush(stdout);
      }
      std::fprintf(stderr, "\r%zu of %zu, %zu failed", ++ended, jobs.size(), failed);
    });
    std::fprintf(stderr, "\n");
  }
  if (options.busy > 0) fs::remove_all(config.work);
  for (const auto& [what, count] : counts) {
    fmt::print("{:<40} {:>5} graded, {} failed\n", what, count.graded, count.failed);
  }
  return failed > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Grades right work: the judge is wrong if any of it fails"};
  app.add_option("--mixtures", options.mixtures, "So many mixtures of variants, by properties")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--mixtures-with-pictures", options.mixtures_with_pictures,
                 "The first so many of them by pictures too")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--variant-seeds", options.variant_seeds, "Every variant with so many seeds")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--tasks", options.tasks, "Only the variants of these tasks");
  app.add_option("--reference-seeds", options.reference_seeds, "The reference with so many seeds")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--reference-seeds-with-pictures", options.reference_seeds_with_pictures,
                 "The first so many of them by pictures too")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--first-seed", options.first_seed,
                 "The first seed of all, and the number of the first mixture")
      ->check(CLI::PositiveNumber);
  app.add_option("--busy", options.busy, "Endless loops that run beside it; nothing is cached")
      ->check(CLI::Range(0, 1000));
  app.add_option("--threads", options.threads, "Submissions at a time")->check(CLI::Range(1, 256));
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
