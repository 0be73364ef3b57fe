// Grades right work, as much as the options say: mixtures of right variants, each variant alone,
// the reference, with many seeds, also next to busy loops. Each verdict is a line of a CSV. Known
// verdicts are not computed again, so the program can be stopped and started at any time. Exit
// status 1: right work has failed, so the judge is wrong.
//
// After a change to a promise, a contract or a picture: nice right_work --variant-seeds 10
// --mixtures 200 --mixtures-with-pictures 40 --whole-seeds 10 --reference-seeds 300
// --reference-seeds-with-pictures 100, and the same with --busy 30. Unaffected jobs are skipped.
#include "grader/base/parallel.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "tests/grader/service/judging/busy_loops.h"
#include "tests/grader/tasks/right_work.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

namespace {

using namespace grader;
using namespace grader::tests;

struct Options {
  std::string out = "build/right_work.csv";
  int mixtures = 0, mixtures_with_pictures = 0;
  int variant_seeds = 0;
  int whole_seeds = 0, whole_seeds_with_pictures = 0;
  int reference_seeds = 0, reference_seeds_with_pictures = 0;
  int first_seed = 1;
  int busy = 0;
  int threads = 2;
};

// Cheap jobs come first, and some of every kind early.
std::vector<RightJob> find_jobs(const build::Config& config, const Options& options) {
  const Choices choices = right_choices(config);
  std::vector<RightJob> jobs;
  const auto seed_of = [&](int i) { return static_cast<std::uint64_t>(options.first_seed + i); };
  for (int i = 0; i < options.variant_seeds; ++i) {
    for (RightJob& job : variant_jobs(choices, seed_of(i))) jobs.push_back(std::move(job));
  }
  for (int i = 0; i < std::max(options.mixtures, options.mixtures_with_pictures); ++i) {
    jobs.push_back(mixture_job(choices, options.first_seed + i));
    jobs.back().pictures = i < options.mixtures_with_pictures;
  }
  for (int i = 0; i < std::max(options.whole_seeds, options.whole_seeds_with_pictures); ++i) {
    for (RightJob& job : whole_jobs(config, seed_of(i))) {
      job.pictures = i < options.whole_seeds_with_pictures;
      jobs.push_back(std::move(job));
    }
  }
  const int references = std::max(options.reference_seeds, options.reference_seeds_with_pictures);
  for (int i = 0; i < references; ++i) {
    jobs.push_back(reference_job(choices, seed_of(i)));
    jobs.back().pictures = i < options.reference_seeds_with_pictures;
  }
  return jobs;
}

// The verdicts by kind, for the last lines.
struct Count {
  int graded = 0, failed = 0;
};

int report(const std::vector<RightRow>& rows, const std::set<std::string>& asked) {
  std::map<std::string, Count> counts;
  for (const RightRow& row : rows) {
    if (!asked.contains(row.key())) continue;
    std::string what = row.kind + (row.pictures ? " with pictures" : " by properties");
    if (row.busy > 0) what += fmt::format(" beside {} busy loops", row.busy);
    Count& count = counts[what];
    ++count.graded;
    count.failed += row.passed ? 0 : 1;
    if (!row.passed) fmt::print("{} {}, seed {}: {}\n", row.kind, row.name, row.seed, row.faults);
  }
  bool failed = false;
  for (const auto& [what, count] : counts) {
    fmt::print("{:<40} {:>5} graded, {} failed\n", what, count.graded, count.failed);
    failed = failed || count.failed > 0;
  }
  return failed ? 1 : 0;
}

int run(const Options& options) {
  build::Config config = build::load_config(build::default_config_path());
  // Verdicts in the judge's cache say nothing about a busy machine.
  if (options.busy > 0) config.work += "/right-busy-" + std::to_string(getpid());
  std::filesystem::create_directories(config.work);
  const sandbox::Isolation isolation = sandbox::probe_isolation(config.root, config.work);

  std::set<std::string> known, asked;
  for (const RightRow& row : read_right_rows(options.out)) known.insert(row.key());
  std::vector<RightJob> jobs;
  for (RightJob& job : find_jobs(config, options)) {
    const std::string key = row_of(config, job, options.busy).key();
    asked.insert(key);
    if (!known.contains(key)) jobs.push_back(std::move(job));
  }
  if (asked.empty()) throw pt::Error("nothing was asked for: see right_work --help");

  std::ofstream csv(options.out, std::ios::app);
  if (!csv) throw pt::Error(options.out + ": cannot be written; choose another --out");
  {
    const BusyLoops loops(options.busy);
    std::size_t ended = 0, failed = 0;
    std::mutex writing;
    base::for_each(jobs.size(), options.threads, [&](std::size_t i) {
      const RightRow row = grade_right(config, isolation, jobs[i], options.busy);
      const std::lock_guard lock(writing);
      csv << to_line(row) + '\n' << std::flush;
      failed += row.passed ? 0 : 1;
      std::fprintf(stderr, "\r%zu of %zu, %zu failed", ++ended, jobs.size(), failed);
    });
    std::fprintf(stderr, "\n");
  }
  if (options.busy > 0) std::filesystem::remove_all(config.work);
  return report(read_right_rows(options.out), asked);
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
  app.add_option("--whole-seeds", options.whole_seeds, "Whole submissions with so many seeds")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--whole-seeds-with-pictures", options.whole_seeds_with_pictures,
                 "The first so many of them by pictures too")
      ->check(CLI::NonNegativeNumber);
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
  app.add_option("--out", options.out,
                 "The CSV: kind, name, seed, pictures, busy, judge, passed, seconds, faults");
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
