#include "measure/calls/candidates.h"

#include "grader/base/files.h"
#include "grader/base/parallel.h"
#include "grader/service/judging/alone.h"
#include "measure/calls/tasks.h"
#include "measure/renders/worker_config.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace measure::calls {

namespace fs = std::filesystem;
using grader::build::Builder;
using grader::build::Built;
using grader::build::Config;
using grader::build::TaskConfig;
using grader::judging::Judged;

namespace {

constexpr int kCompileSeconds = 60;
const char* const kFast = "fast";

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

// The candidates besides the reference, in alphabetical order: right solutions, and the render
// program's faster form of the task. The learners' edition has only the faster form.
std::vector<std::string> others(const Materials& materials, const std::string& slug) {
  std::vector<std::string> names;
  const fs::path folder = fs::path(materials.config.root) / "grader/tasks" / slug / "right";
  for (const fs::path& file : grader::base::sources_in(folder)) names.push_back(file.stem());
  if (materials.fast.contains(slug)) names.emplace_back(kFast);
  std::sort(names.begin(), names.end());
  return names;
}

const TaskConfig& config_of(const Config& config, const std::string& slug) {
  return *std::find_if(config.tasks.begin(), config.tasks.end(),
                       [&](const TaskConfig& task) { return task.slug == slug; });
}

// Names of candidates besides the reference, by task.
using Asked = std::map<std::string, std::vector<std::string>>;

// The task in "hit_sphere.half_b"; "" for other words, such as "1.3".
std::string task_named(const Config& config, const std::string& word) {
  const std::string slug = word.substr(0, word.find('.'));
  const bool known = std::any_of(config.tasks.begin(), config.tasks.end(),
                                 [&](const TaskConfig& task) { return task.slug == slug; });
  return known && slug.size() < word.size() ? slug : "";
}

void add_named(const Materials& materials, const std::string& slug, const std::string& word,
               Asked& asked) {
  const std::string name = word.substr(slug.size() + 1);
  const std::vector<std::string> known = others(materials, slug);
  if (std::ranges::count(known, name) == 0) {
    throw pt::Error(
        known.empty() ? fmt::format("there is no '{}': nothing is here beside the reference", word)
                      : fmt::format("there is no '{}'; of {} there are: {}", word, slug,
                                    fmt::join(known, ", ")));
  }
  if (std::ranges::count(asked[slug], name) == 0) asked[slug].push_back(name);
}

Asked names_asked(const Materials& materials, const std::vector<std::string>& what) {
  const Config& config = materials.config;
  Asked asked;
  std::vector<std::string> whole;
  for (const std::string& word : what) {
    const std::string slug = task_named(config, word);
    if (!slug.empty()) {
      add_named(materials, slug, word, asked);
    } else {
      for (const std::string& meant : grader::judging::tasks_meant(config, word))
        whole.push_back(meant);
    }
  }
  if (what.empty()) {
    for (const TaskConfig& task : config.tasks) whole.push_back(task.slug);
  }
  for (const std::string& slug : whole) asked.insert_or_assign(slug, others(materials, slug));
  return asked;
}

// Builds candidates. Objects are kept by their compile settings, so that both kinds of worker share
// them.
class Workshop {
 public:
  explicit Workshop(const Materials& materials)
      : plain_config_(materials.config),
        counted_config_(recorded(materials.config)),
        plain_(plain_config_, materials.tier, kCompileSeconds),
        counted_(counted_config_, materials.tier, kCompileSeconds) {}

  // Completes the candidate from its object, or sets the reason why that is impossible.
  void finish(const Judged& judged, bool counts, Candidate& candidate) const {
    if (!judged.object.ok()) {
      const auto& result = judged.result;
      candidate.problem = result.reason;
      if (!result.compiler_output.empty())
        candidate.problem += ": " + first_line(result.compiler_output);
      return;
    }
    const auto link = [&](const Config& config, const Builder& builder) {
      const Built worker = grader::judging::link_alone(config, builder, judged,
                                                       grader::judging::Elsewhere::reference);
      if (!worker.ok()) candidate.problem = "it does not link: " + first_line(worker.error);
      return worker.path;
    };
    candidate.plain = link(plain_config_, plain_);
    if (counts && candidate.problem.empty()) candidate.counted = link(counted_config_, counted_);
  }

  // A task that is already compiled.
  Judged compiled(const TaskConfig& task, const grader::build::Paths& objects) const {
    Judged judged = grader::judging::not_judged(plain_config_, task);
    judged.object = {objects.at(0), grader::base::stamp(objects.at(0)), "", "", ""};
    return judged;
  }

  Judged right(const TaskConfig& task, const std::string& name) const {
    Judged judged = grader::judging::not_judged(plain_config_, task);
    const fs::path folder = fs::path(plain_config_.root) / "grader/tasks" / task.slug / "right";
    judged.object = plain_.compile(task, pt::read_file(folder / (name + ".cpp")));
    judged.result.reason =
        judged.object.rejected.empty() ? "it does not compile" : judged.object.rejected;
    judged.result.compiler_output = judged.object.error;
    return judged;
  }

  // From a folder, or the object of a mistake in a handout.
  Judged own(const TaskConfig& task, const std::string& folder) const {
    if (fs::is_regular_file(folder)) return compiled(task, {folder});
    grader::judging::GradeRequest request;
    request.submission = folder;
    std::vector<Judged> judged{grader::judging::not_judged(plain_config_, task)};
    grader::judging::compile_all(plain_, request, judged);
    return judged[0];
  }

 private:
  const Config plain_config_, counted_config_;
  const Builder plain_, counted_;
};

// The code that is named for this task, or else the code for all tasks.
std::vector<Own> own_of(const Options& options, const std::string& slug) {
  std::vector<Own> found;
  for (const std::string& key : {slug, std::string()}) {
    std::ranges::copy_if(options.own, std::back_inserter(found),
                         [&](const Own& own) { return own.slug == key; });
    if (!found.empty()) break;
  }
  return found;
}

std::vector<Contest> contests_of(const Materials& materials, const Options& options) {
  const Asked asked = names_asked(materials, options.what);
  std::vector<Contest> contests;
  for (const About& about : tasks()) {
    if (!asked.contains(about.slug)) continue;
    Contest contest{&about, {{"reference", "", "", "", ""}}};
    for (const std::string& name : asked.at(about.slug)) {
      contest.candidates.push_back({name, "", "", "", ""});
    }
    for (const Own& own : own_of(options, about.slug)) {
      contest.candidates.push_back({own.name, own.folder, "", "", ""});
    }
    contests.push_back(contest);
  }
  return contests;
}

}  // namespace

std::vector<Contest> find_contests(const Materials& materials, const Options& options,
                                   const std::function<void(double)>& progress) {
  std::vector<Contest> contests = contests_of(materials, options);
  struct Job {
    const Contest* contest;
    Candidate* candidate;
  };
  std::vector<Job> jobs;
  for (Contest& contest : contests) {
    for (Candidate& candidate : contest.candidates) jobs.push_back({&contest, &candidate});
  }
  const Workshop workshop(materials);
  std::mutex mutex;
  std::size_t done = 0;
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  grader::base::for_each(jobs.size(), threads, [&](std::size_t i) {
    const Contest& contest = *jobs[i].contest;
    Candidate& candidate = *jobs[i].candidate;
    const About& about = *contest.about;
    const TaskConfig& task = config_of(materials.config, about.slug);
    const Judged judged = [&] {
      if (candidate.is_own()) return workshop.own(task, candidate.own);
      if (&candidate == contest.candidates.data()) return workshop.compiled(task, task.reference);
      if (candidate.name == kFast) return workshop.compiled(task, materials.fast.at(about.slug));
      return workshop.right(task, candidate.name);
    }();
    workshop.finish(judged, about.kind == Kind::tree, candidate);
    const std::lock_guard lock(mutex);
    progress(static_cast<double>(++done) / static_cast<double>(jobs.size()));
  });
  return contests;
}

}  // namespace measure::calls
