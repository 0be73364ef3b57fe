// known_mistakes: measures every solution in grader/tasks/*/wrong, and writes the fingerprint of
// each into grader/mistakes/known.json. Measurements are kept in a folder, so that it may be
// stopped and started at any time. Then the check of what is known: each wrong solution is handed
// in, with other random numbers, and named or not; the right ones too; and each once more with its
// own fingerprint taken away.
#include "grader/base/files.h"
#include "grader/base/parallel.h"
#include "grader/base/sha256.h"
#include "grader/self_check/measure_mistakes.h"
#include "grader/self_check/naming_score.h"
#include "grader/self_check/stale_mistakes.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <atomic>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace grader;
using namespace grader::self_check;
namespace fs = std::filesystem;

struct Options {
  std::string store = "build/known_mistakes";
  std::string out;
  std::vector<std::string> tasks;
  int threads = 2;
  int each = 0;  // of a kind and task, at most; 0: all
  bool check = false;
  bool stale = false;
  bool verbose = false;
};

// The project's own demands: parts of the solutions, in [0, 1].
constexpr double kMinNamed = 0.8, kMaxLeftOut = 0.02;

using All = std::map<std::string, std::vector<std::pair<Kept, MeasuredSolution>>>;  // by slug

// The reference and all others; or a few of each kind, always the same.
std::vector<Kept> chosen(const judge::Config& config, const judge::TaskConfig& task, int each) {
  std::vector<Kept> all = kept_solutions(config, task, {"reference"});
  for (const char* kind : {"right", "wrong", "variation"}) {
    std::vector<Kept> some = kept_solutions(config, task, {kind});
    if (each > 0 && some.size() > static_cast<std::size_t>(each)) {
      std::ranges::sort(some, {}, [](const Kept& kept) { return base::sha256(kept.name); });
      some.resize(each);
    }
    for (Kept& kept : some) all.push_back(std::move(kept));
  }
  return all;
}

All measure_all(const judge::Config& config, const judge::GradeRequest& request,
                const Options& options) {
  std::vector<Kept> kept;
  for (const judge::TaskConfig& task : config.tasks) {
    const bool asked = options.tasks.empty() ||
                       std::count(options.tasks.begin(), options.tasks.end(), task.slug) > 0;
    if (!asked) continue;
    for (Kept& each : chosen(config, task, options.each)) kept.push_back(std::move(each));
  }
  std::vector<MeasuredSolution> measured(kept.size());
  std::atomic<int> ended = 0;
  base::for_each(kept.size(), options.threads, [&](std::size_t i) {
    measured[i] = measure(config, request, kept[i], fs::absolute(options.store),
                          options.check ? Extent::trial : Extent::all);
    std::fprintf(stderr, "\r%d of %zu solutions", ++ended, kept.size());
  });
  std::fprintf(stderr, "\n");
  All all;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    all[kept[i].task->slug].emplace_back(kept[i], measured[i]);
  }
  return all;
}

mistakes::KnownTask known_of(const std::vector<std::pair<Kept, MeasuredSolution>>& solutions) {
  mistakes::KnownTask task;
  for (const auto& [kept, measured] : solutions) {
    if (kept.kind == "reference") {
      task.battery = measured.battery;
      task.right = measured.answers;
    }
  }
  for (const auto& [kept, measured] : solutions) {
    // A solution that breaks only a bonus promise passes, and a solution that passes is not named.
    const bool fails = !measured.broken.empty() || !measured.unsure.empty();
    if (kept.kind != "wrong" || !fails) continue;
    mistakes::Fingerprint print{kept.name,       sentence_of(kept.text), measured.source,
                                measured.broken, measured.unsure,        measured.answers};
    task.mistakes.push_back(print);
  }
  return task;
}

mistakes::KnownMistakes load_known(const std::string& path) {
  return fs::exists(path) ? mistakes::known_from_json(base::read_file(path), path)
                          : mistakes::KnownMistakes{};
}

int tell_stale(const judge::Config& config, const mistakes::KnownMistakes& known) {
  const std::vector<std::string> reasons = out_of_date(config, known);
  for (const std::string& reason : reasons) fmt::print("{}\n", reason);
  if (!reasons.empty()) {
    fmt::print(
        "grader/mistakes/known.json is out of date; make it again:\n"
        "  ninja -C build/check known_mistakes && build/check/grader/known_mistakes\n");
  }
  return reasons.empty() ? 0 : 1;
}

int tell_score(const mistakes::KnownMistakes& known, const All& all, const Options& options) {
  Score score;
  for (const auto& [slug, solutions] : all) {
    for (const auto& [kept, measured] : solutions) {
      score.add(known.at(slug), slug, kept.kind, kept.name, measured.trial);
    }
  }
  fmt::print("{}", score.text(options.verbose || options.check));
  if (score.misnamed() > 0) return 1;
  const bool few = options.each > 0 || !options.tasks.empty();
  return few || (score.share_named() >= kMinNamed && score.share_left_out() <= kMaxLeftOut) ? 0 : 1;
}

int run(const Options& options) {
  const judge::Config config = judge::load_config(judge::default_config_path());
  for (const std::string& task : options.tasks) judge::tasks_meant(config, task);
  const std::string path =
      options.out.empty() ? config.root + "/grader/mistakes/known.json" : options.out;
  mistakes::KnownMistakes known = load_known(path);
  if (options.stale) return tell_stale(config, known);

  fs::create_directories(options.store);
  judge::GradeRequest request;
  request.isolation = sandbox::probe_isolation(config.root, config.work);
  const All all = measure_all(config, request, options);
  if (!options.check) {
    if (options.each > 0)
      throw pt::Error("a file of some solutions only is of no use: add --check");
    for (const auto& [slug, solutions] : all) known[slug] = known_of(solutions);
    const std::string text = to_json(known);
    pt::write_file(path, text);
    known = mistakes::known_from_json(text, path);  // as a reader has it
  }
  return tell_score(known, all, options);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Measures the known mistakes, and checks that they are named right"};
  app.add_option("task", options.tasks, "Tasks; default: all");
  app.add_option("--threads", options.threads, "At a time")->check(CLI::Range(1, 256));
  app.add_option("--store", options.store, "The folder of what is measured already");
  app.add_option("--out", options.out, "The file to write; default: grader/mistakes/known.json");
  app.add_flag("--check", options.check, "Write nothing: check the file that is there");
  app.add_option("--each", options.each, "Of each task and kind, only so many");
  app.add_flag("--stale", options.stale, "Only say whether the file is out of date");
  app.add_flag("--verbose", options.verbose, "Tell of every solution");
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
