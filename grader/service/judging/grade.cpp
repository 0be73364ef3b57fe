#include "grader/service/judging/grade.h"

#include "grader/results/points.h"
#include "grader/service/build/cache.h"
#include "grader/service/judging/alone.h"
#include "grader/service/judging/name_mistakes.h"
#include "grader/service/judging/no_reference.h"
#include "grader/service/judging/pictures.h"
#include "grader/service/judging/so_far.h"
#include "grader/service/judging/together.h"
#include "grader/service/process/run_command.h"
#include "grader/tasks.h"
#include "pt/error.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <set>

#include <fmt/format.h>

namespace grader::judging {

namespace {

using Clock = std::chrono::steady_clock;

// The requested tasks and all that they need, in the order of the course. Without a reference, a
// picture needs all tasks.
std::vector<const build::TaskConfig*> to_judge(const build::Config& config,
                                               const std::vector<std::string>& asked) {
  std::set<std::string> wanted(asked.begin(), asked.end());
  for (const std::string& slug : asked) {
    wanted.insert(needs(slug).begin(), needs(slug).end());
  }
  std::vector<const build::TaskConfig*> tasks;
  for (const build::TaskConfig& task : config.tasks) {
    if (wanted.contains(task.slug) || !config.no_reference.empty()) tasks.push_back(&task);
  }
  return tasks;
}

// The versions that verdicts depend on, besides the submission. The first is what `./run --version`
// prints.
std::vector<std::string> versions(const build::Config& config) {
  std::vector<std::string> all{"Firstlight " + config.version, config.compiler_version};
  const process::CommandResult commit = process::run_command(
      {{"/usr/bin/git", "-C", config.root, "describe", "--always", "--dirty=-changed"},
       {"PATH=/usr/bin", "LANG=C.UTF-8"},
       {},
       "",
       {}},
      std::chrono::seconds(5));
  if (commit.ok()) all.push_back("commit " + commit.output.substr(0, commit.output.find('\n')));
  return all;
}

// Without this check, an unknown name in the points would silently have no effect.
void check_names(const results::Points& points, const std::vector<Judged>& judged,
                 const std::string& path) {
  const auto check = [&](const auto& special, const auto& all, auto name, const char* what) {
    for (const auto& [key, worth] : special) {
      if (std::ranges::count(all, key, name) > 0 || all.empty()) continue;
      throw pt::Error(fmt::format("{}: {} is not a {} of its task", path, key, what));
    }
  };
  for (const Judged& each : judged) {
    const auto found = points.find(each.config->slug);
    if (found == points.end()) continue;
    check(found->second.promises, each.result.promises, &results::PromiseResult::name, "promise");
    check(found->second.pictures, each.result.pictures, &results::PictureResult::recipe, "picture");
  }
}

// Without this check, a misspelt name in a dialect would do nothing, and its promise would be judged.
void check_dialect(const door::Dialect& dialect, const std::vector<Judged>& judged) {
  for (const Judged& each : judged) {
    const auto found = dialect.promises.find(each.config->slug);
    if (found == dialect.promises.end()) continue;
    for (const auto& [name, change] : found->second) {
      if (std::ranges::count(each.result.promises, name, &results::PromiseResult::name) > 0)
        continue;
      throw pt::Error(fmt::format("grader/door/dialects: {}: {} is not a promise of {}",
                                  dialect.name, name, each.config->slug));
    }
  }
}

constexpr const char* kLearnersFolder = "student";

std::string folder_shown(const GradeRequest& request) {
  return request.shown.empty() ? request.submission : request.shown;
}

// One run of the judge.
class Run {
 public:
  Run(const build::Config& config, const GradeRequest& request)
      : config_(config),
        request_(request),
        points_(results::load_points(config.root + "/grader/points.json")) {
    results_.submission = request.name.empty() ? folder_shown(request) : request.name;
    results_.seed = request.seed;
    results_.isolation = request.isolation.words;
    if (!config.no_reference.empty()) {
      results_.isolation +=
          "; each task is judged with your own other tasks only, as " + config.no_reference;
    }
    results_.command = request.command;
    for (const build::TaskConfig* task : to_judge(config, request.asked)) {
      if (task->graded.empty()) {
        throw pt::Error(task->slug + " has no properties: nothing about it can be judged");
      }
      judged_.push_back(not_judged(config, *task));
    }
    if (request.pictures) list_pictures(config, request, judged_);
    check_names(points_, judged_, config.root + "/grader/points.json");
    if (request.dialect) {
      check_dialect(*request.dialect, judged_);
      results_.dialect = request.dialect->name;
      for (Judged& each : judged_) door::translate(*request.dialect, each.result);
    }
    for (const build::TaskConfig& task : config.tasks) {
      if (is_asked(task.slug)) results_.asked.push_back(task.slug);
    }
  }

  results::Results judge(const std::function<void(const results::Results&)>& progress) {
    if (!request_.refused.empty()) return refused(progress);
    const build::Builder builder(config_, request_.isolation.tier, request_.compile_limit);
    for (const std::string& folder : {config_.work, builder.cache(), config_.work + "/hints"}) {
      build::remove_left_overs(folder);
    }
    build::trim_cache_now_and_then(builder.cache());
    const auto report = [&] { progress(summary()); };
    report();
    phase("compiling", [&] {
      // Meanwhile git looks at every file of the project.
      auto judged_with = std::async(std::launch::async, [&] { return versions(config_); });
      compile_all(builder, request_, judged_);
      results_.versions = judged_with.get();
      if (!request_.note.empty()) results_.versions.push_back("of the files, " + request_.note);
    });
    report();
    phase("properties", [&] {
      if (!config_.no_reference.empty()) config_ = with_own_tasks(config_, judged_);
      judge_alone(config_, builder, request_, judged_, report);
      // Without a reference, a task may fail because of another task.
      if (config_.no_reference.empty()) {
        name_mistakes(config_, builder, request_, judged_, report);
        for (Judged& each : judged_) {
          if (request_.dialect) door::settle_cause(*request_.dialect, each.result);
        }
      }
      if (!config_.no_reference.empty()) block_by_own_tasks(judged_);
      judge_together(config_, builder, request_, judged_, report);
    });
    if (request_.pictures) {
      report();
      phase("pictures", [&] { judge_pictures(config_, builder, request_, judged_, report); });
    }
    results::Results results = summary();
    results.complete = true;
    progress(results);
    return results;
  }

 private:
  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  bool is_asked(const std::string& slug) const {
    return std::find(request_.asked.begin(), request_.asked.end(), slug) != request_.asked.end();
  }

  template <class Work>
  void phase(const std::string& name, const Work& work) {
    const auto start = Clock::now();
    work();
    results_.phases.push_back({name, seconds_since(start)});
  }

  // The results if it cannot be told which files are to be judged.
  results::Results refused(const std::function<void(const results::Results&)>& progress) {
    for (Judged& each : judged_) {
      each.result.state = results::State::rejected;
      each.result.reason = request_.refused;
      each.settled = true;
      for (results::PictureResult& picture : each.result.pictures) {
        picture.state = results::State::not_attempted;
        picture.text = "not rendered";
      }
    }
    results::Results results = summary();
    results.complete = true;
    progress(results);
    return results;
  }

  // The results so far.
  results::Results summary() const {
    results::Results results = results_;
    for (const Judged& each : judged_) {
      if (is_asked(each.config->slug))
        results.tasks.push_back(
            without_folder(without_folder(so_far(each), config_.work), config_.root));
    }
    for (results::TaskResult& task : results.tasks) results::count_points(points_, task);
    results.seconds = seconds_since(start_);
    return results;
  }

  build::Config config_;  // with this run's version of all other tasks
  const GradeRequest& request_;
  const Clock::time_point start_ = Clock::now();
  const results::Points points_;
  results::Results results_;
  std::vector<Judged> judged_;
};

}  // namespace

results::Results grade(const build::Config& config, const GradeRequest& request,
                       const std::function<void(const results::Results&)>& progress) {
  return Run(config, request).judge(progress);
}

void check_points_and_goldens(const build::Config& config) {
  GradeRequest request;
  for (const build::TaskConfig& task : config.tasks) {
    if (!task.graded.empty()) request.asked.push_back(task.slug);
  }
  Run(config, request);
}

std::string shown_folder(const GradeRequest& request) {
  return request.name.empty() ? folder_shown(request) : kLearnersFolder;
}

std::string replay_command(const GradeRequest& request, const std::string& slug) {
  const std::string folder = shown_folder(request);
  const std::string replay = fmt::format("./run grade {} --seed {}", slug, request.seed);
  return folder == kLearnersFolder ? replay : replay + " --submission " + folder;
}

std::vector<std::string> tasks_judged(const build::Config& config,
                                      const std::vector<std::string>& asked) {
  std::vector<std::string> slugs;
  for (const build::TaskConfig* task : to_judge(config, asked)) slugs.push_back(task->slug);
  return slugs;
}

std::vector<std::string> tasks_meant(const build::Config& config, const std::string& word) {
  std::vector<std::string> slugs;
  for (const build::TaskConfig& task : config.tasks) {
    const bool meant = word == task.slug || word == task.number || word == task.part ||
                       word == task.part.substr(0, task.part.find('_'));
    if (meant) slugs.push_back(task.slug);
  }
  if (slugs.empty()) {
    throw pt::Error("'" + word +
                    "' is neither a task nor a part: write a name like hit_triangle, or a "
                    "part like 1");
  }
  return slugs;
}

}  // namespace grader::judging
