#include "grader/service/judging/pictures.h"

#include "grader/base/parallel.h"
#include "grader/pictures/goldens/provenance.h"
#include "grader/service/judging/no_reference.h"
#include "grader/service/judging/picture_trial.h"
#include "grader/service/judging/together.h"

#include <algorithm>
#include <mutex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::judging {

namespace {

// One recipe and the tasks of the submission that it judges.
struct Exhibit {
  pictures::Recipe recipe;
  std::vector<Judged*> tasks;
};

std::vector<Exhibit> exhibits(const build::Config& config, const GradeRequest& request,
                              std::vector<Judged>& judged) {
  std::vector<Exhibit> all;
  for (const pictures::Recipe& recipe :
       pictures::load_recipes(config.root + "/scenes/recipes.json")) {
    Exhibit exhibit{recipe, {}};
    for (Judged& each : judged) {
      const std::string& slug = each.config->slug;
      const bool asked = std::ranges::count(request.asked, slug) > 0;
      if (asked && std::ranges::count(recipe.tasks, slug) > 0) {
        exhibit.tasks.push_back(&each);
      }
    }
    if (!exhibit.tasks.empty()) all.push_back(exhibit);
  }
  return all;
}

class Gallery {
 public:
  Gallery(const build::Config& config, const build::Builder& builder, const GradeRequest& request,
          std::vector<Judged>& judged)
      : config_(config),
        builder_(builder),
        request_(request),
        judged_(judged),
        exhibits_(exhibits(config, request, judged)) {}

  void run(const std::function<void()>& progress) {
    for (const Exhibit& exhibit : exhibits_) {
      for (Judged* task : exhibit.tasks) {
        if (attempted(*task)) continue;
        put(*task, without_picture(exhibit.recipe, results::State::not_attempted, "not rendered"));
      }
    }
    link_what_is_right();
    base::for_each(judged_.size(), request_.threads, [&](std::size_t i) { try_first(judged_[i]); });
    base::for_each(exhibits_.size(), request_.threads, [&](std::size_t i) {
      judge(exhibits_[i]);
      const std::lock_guard lock(mutex_);
      progress();
    });
  }

 private:
  static bool attempted(const Judged& task) {
    return task.object.ok() && task.result.state != results::State::not_attempted;
  }

  void link_what_is_right() {
    const bool together = std::ranges::any_of(exhibits_, [](const Exhibit& exhibit) {
      return std::ranges::any_of(exhibit.tasks, &Judged::right_alone);
    });
    if (together) together_ = link_together(config_, builder_, judged_, Elsewhere::reference);
    for (const Judged& each : judged_) {
      if (each.right_alone) content_ += each.content;
    }
  }

  // If a task did not answer its promises in time, its first picture decides whether the others are
  // rendered: else a submission of endless loops would take ten minutes.
  void try_first(Judged& task) {
    if (task.result.state != results::State::timeout || !config_.no_reference.empty()) return;
    const auto first = std::ranges::find_if(exhibits_, [&](const Exhibit& exhibit) {
      return std::ranges::count(exhibit.tasks, &task) > 0;
    });
    if (first == exhibits_.end()) return;
    const results::PictureResult found = look_at(first->recipe, task);
    if (found.state != results::State::timeout) return;
    for (const Exhibit& exhibit : exhibits_) {
      if (std::ranges::count(exhibit.tasks, &task) == 0) continue;
      const bool is_first = exhibit.recipe.name == found.recipe;
      put(task, is_first ? found
                         : without_picture(
                               exhibit.recipe, found.state,
                               fmt::format("not rendered: {} for {}", found.text, found.recipe)));
    }
    const std::lock_guard lock(mutex_);
    silent_.insert(&task);
  }

  // Without a reference, a wrong task spoils the pictures of all other tasks.
  bool waits(const Exhibit& exhibit) {
    if (config_.no_reference.empty()) return false;
    const std::vector<std::string> missing = missing_for(exhibit.recipe.tasks, judged_);
    if (missing.empty()) return false;
    const results::PictureResult result =
        without_picture(exhibit.recipe, results::State::not_attempted,
                        fmt::format("not rendered: without the reference it waits for {}",
                                    fmt::join(missing, ", ")));
    for (Judged* task : exhibit.tasks) put(*task, result);
    return true;
  }

  void judge(const Exhibit& exhibit) {
    if (waits(exhibit)) return;
    std::vector<Judged*> right;
    for (Judged* task : exhibit.tasks) {
      if (!attempted(*task) || silent_.contains(task)) continue;
      const bool by_itself = exhibit.recipe.adaptive || !task->right_alone;
      if (by_itself) {
        put(*task, task->right_alone ? judge_alone(exhibit.recipe, *task)
                                     : look_at(exhibit.recipe, *task));
      } else {
        right.push_back(task);
      }
    }
    if (!right.empty()) judge_together(exhibit.recipe, right);
  }

  static bool passes(const results::PictureResult& picture) {
    return picture.state == results::State::pass;
  }

  // First all tasks at once; only if that fails, one after the other.
  void judge_together(const pictures::Recipe& recipe, const std::vector<Judged*>& tasks) {
    const results::PictureResult together = trial(recipe, *tasks[0], together_, content_, true);
    if (passes(together)) {
      for (Judged* task : tasks) put(*task, together);
      return;
    }
    // All are entered at the same time: before, a report must not say that the task passes.
    std::vector<results::PictureResult> alone;
    alone.reserve(tasks.size());
    for (const Judged* task : tasks) alone.push_back(judge_alone(recipe, *task));
    if (!std::all_of(alone.begin(), alone.end(), passes)) {
      for (std::size_t i = 0; i < tasks.size(); ++i) put(*tasks[i], alone[i]);
      return;
    }
    // The verdict on a small mistake depends on the samples. If the verdict is the same with the
    // reference in place of the other tasks, they are not the reason.
    std::vector<results::PictureResult> same_samples;
    for (const Judged* task : tasks) {
      same_samples.push_back(trial(recipe, *task, by_itself(*task), content_, true));
      same_samples.back().integrated = false;
    }
    if (!std::all_of(same_samples.begin(), same_samples.end(), passes)) {
      for (std::size_t i = 0; i < tasks.size(); ++i) {
        put(*tasks[i], passes(same_samples[i]) ? alone[i] : same_samples[i]);
      }
      return;
    }
    results::PictureResult result = together;
    result.text = fmt::format("right with the reference elsewhere, not with your other tasks: {}",
                              together.text);
    const std::vector<std::string> blamed = blame(recipe, *tasks[0], tasks);
    if (!blamed.empty())
      result.text += fmt::format(" (only with your {})", fmt::join(blamed, ", "));
    for (Judged* task : tasks) put(*task, result);
  }

  // The tasks that make the picture right if the reference replaces them, with the same samples.
  std::vector<std::string> blame(const pictures::Recipe& recipe, const Judged& task,
                                 const std::vector<Judged*>& judged_by_it) const {
    std::vector<std::string> blamed;
    for (const Judged& other : judged_) {
      const bool known = std::any_of(judged_by_it.begin(), judged_by_it.end(),
                                     [&](const Judged* each) { return each == &other; });
      if (!other.right_alone || known) continue;
      const std::string& slug = other.config->slug;
      const build::Built worker =
          link_together(config_, builder_, judged_, Elsewhere::reference, slug);
      if (worker.ok() && passes(trial(recipe, task, worker, content_, true))) {
        blamed.push_back(slug);
      }
    }
    return blamed;
  }

  build::Built by_itself(const Judged& task) const {
    return link_alone(config_, builder_, task, Elsewhere::reference);
  }

  results::PictureResult judge_alone(const pictures::Recipe& recipe, const Judged& task) const {
    return trial(recipe, task, by_itself(task), task.content, false);
  }

  results::PictureResult look_at(const pictures::Recipe& recipe, const Judged& task) const {
    return trial(recipe, task, by_itself(task), task.content, false, true);
  }

  results::PictureResult trial(const pictures::Recipe& recipe, const Judged& task,
                               const build::Built& worker, const std::string& content,
                               bool integrated, bool known_wrong = false) const {
    if (!worker.ok()) {
      return without_picture(recipe, results::State::fail, "it does not link: " + worker.error);
    }
    return try_picture(config_, builder_, request_,
                       {recipe, *task.config, worker, content, integrated, known_wrong});
  }

  void put(Judged& task, const results::PictureResult& found) {
    const std::lock_guard lock(mutex_);
    for (results::PictureResult& picture : task.result.pictures) {
      if (picture.recipe == found.recipe) picture = found;
    }
  }

  const build::Config& config_;
  const build::Builder& builder_;
  const GradeRequest& request_;
  std::vector<Judged>& judged_;
  std::vector<Exhibit> exhibits_;
  std::set<const Judged*> silent_;  // tasks whose pictures have their verdict: no answer in time
  build::Built together_;
  std::string content_;  // of all tasks that are right alone
  std::mutex mutex_;
};

}  // namespace

void list_pictures(const build::Config& config, const GradeRequest& request,
                   std::vector<Judged>& judged) {
  for (const Exhibit& exhibit : exhibits(config, request, judged)) {
    pictures::expect_as_made(pictures::golden_files(config.root + "/golden", exhibit.recipe.name));
    for (Judged* task : exhibit.tasks) task->result.pictures.push_back(not_judged(exhibit.recipe));
  }
}

void judge_pictures(const build::Config& config, const build::Builder& builder,
                    const GradeRequest& request, std::vector<Judged>& judged,
                    const std::function<void()>& progress) {
  Gallery(config, builder, request, judged).run(progress);
}

}  // namespace grader::judging
