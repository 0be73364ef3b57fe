#include "grader/judge/pictures.h"

#include "grader/judge/integration.h"
#include "grader/judge/no_reference.h"
#include "grader/judge/parallel.h"
#include "grader/judge/picture_trial.h"

#include <algorithm>
#include <mutex>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader {

namespace {

// How often the limit of a call a few rows of a picture may take.
constexpr int kPatience = 5;

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

// One recipe and the tasks of the submission that it judges.
struct Exhibit {
  const Recipe* recipe;
  std::vector<Judged*> tasks;
};

class Gallery {
 public:
  Gallery(const Config& config, const Builder& builder, const GradeRequest& request,
          std::vector<Judged>& judged)
      : config_(config),
        builder_(builder),
        request_(request),
        judged_(judged),
        recipes_(load_recipes(config.root + "/scenes/recipes.json")) {
    for (const Recipe& recipe : recipes_) {
      Exhibit exhibit{&recipe, {}};
      for (Judged& each : judged_) {
        const std::string& slug = each.config->slug;
        if (contains(request.asked, slug) && contains(recipe.tasks, slug)) {
          exhibit.tasks.push_back(&each);
        }
      }
      if (!exhibit.tasks.empty()) exhibits_.push_back(exhibit);
    }
  }

  void run(const std::function<void()>& progress) {
    for (const Exhibit& exhibit : exhibits_) {
      for (Judged* task : exhibit.tasks) task->result.pictures.push_back(blank(*exhibit.recipe));
    }
    link_workers();
    for_each(exhibits_.size(), request_.threads, [&](std::size_t i) {
      judge(exhibits_[i]);
      const std::lock_guard lock(mutex_);
      progress();
    });
    for (Judged& each : judged_) enter_state(each.result);
  }

 private:
  PictureResult blank(const Recipe& recipe) const {
    PictureResult result;
    result.recipe = recipe.name;
    result.title = recipe.title;
    result.width = recipe.width;
    result.height = recipe.height;
    result.text = "not rendered";
    return result;
  }

  static bool attempted(const Judged& task) {
    return task.object.ok() && task.result.state != State::not_attempted;
  }

  void link_workers() {
    bool together = false;
    for (const Exhibit& exhibit : exhibits_) {
      for (Judged* task : exhibit.tasks) {
        together = together || task->right_alone;
        if (attempted(*task)) alone_[task->config->slug];
      }
    }
    if (together) together_ = link_together(config_, builder_, judged_, Elsewhere::reference);
    for (auto& [slug, worker] : alone_) {
      for (const Judged& each : judged_) {
        if (each.config->slug == slug) {
          worker = link_alone(config_, builder_, each, Elsewhere::reference);
        }
      }
    }
    for (const Judged& each : judged_) {
      if (each.right_alone) content_ += each.content;
    }
  }

  // Without a reference, what is not right spoils the pictures of all others.
  bool waits(const Exhibit& exhibit) {
    if (config_.no_reference.empty()) return false;
    const std::vector<std::string> missing = missing_for(exhibit.recipe->tasks, judged_);
    if (missing.empty()) return false;
    PictureResult result = blank(*exhibit.recipe);
    result.text = fmt::format("not rendered: without the reference it waits for {}",
                              fmt::join(missing, ", "));
    for (Judged* task : exhibit.tasks) put(*task, result);
    return true;
  }

  void judge(const Exhibit& exhibit) {
    if (waits(exhibit)) return;
    std::vector<Judged*> right;
    for (Judged* task : exhibit.tasks) {
      if (!attempted(*task)) continue;
      const bool by_itself = exhibit.recipe->adaptive || !task->right_alone;
      if (by_itself) {
        put(*task, task->right_alone ? judge_alone(*exhibit.recipe, *task)
                                     : look_at(*exhibit.recipe, *task));
      } else {
        right.push_back(task);
      }
    }
    if (!right.empty()) judge_together(*exhibit.recipe, right);
  }

  // All at once; and only if that fails, one after the other.
  void judge_together(const Recipe& recipe, const std::vector<Judged*>& tasks) {
    const PictureResult together = trial(recipe, *tasks[0], together_, content_, true);
    bool all_right = true;
    for (Judged* task : tasks) {
      const PictureResult result =
          together.state == State::pass ? together : judge_alone(recipe, *task);
      put(*task, result);
      all_right = all_right && result.state == State::pass;
    }
    if (together.state == State::pass || !all_right) return;
    PictureResult result = together;
    result.text = fmt::format("right with the reference elsewhere, not with your other tasks: {}",
                              together.text);
    const std::vector<std::string> blamed = blame(recipe, *tasks[0], tasks);
    if (!blamed.empty())
      result.text += fmt::format(" (only with your {})", fmt::join(blamed, ", "));
    for (Judged* task : tasks) put(*task, result);
  }

  // The tasks with whose reference the picture is right.
  std::vector<std::string> blame(const Recipe& recipe, const Judged& task,
                                 const std::vector<Judged*>& judged_by_it) const {
    std::vector<std::string> blamed;
    for (const Judged& other : judged_) {
      const bool known = std::any_of(judged_by_it.begin(), judged_by_it.end(),
                                     [&](const Judged* each) { return each == &other; });
      if (!other.right_alone || known) continue;
      const std::string& slug = other.config->slug;
      const Built worker = link_together(config_, builder_, judged_, Elsewhere::reference, slug);
      if (worker.ok() && trial(recipe, task, worker, content_ + slug, true).state == State::pass)
        blamed.push_back(slug);
    }
    return blamed;
  }

  PictureResult judge_alone(const Recipe& recipe, const Judged& task) const {
    return trial(recipe, task, alone_.at(task.config->slug), task.content, false);
  }

  // A picture of a task that is wrong already: one stage, and little patience with one that does
  // not answer, or a submission of endless loops would take ten minutes.
  PictureResult look_at(const Recipe& recipe, const Judged& task) const {
    return trial(recipe, task, alone_.at(task.config->slug), task.content, false, 1,
                 task.result.state == State::timeout ? 1 : kPatience);
  }

  PictureResult trial(const Recipe& recipe, const Judged& task, const Built& worker,
                      const std::string& content, bool integrated, int stages = 3,
                      int patience = kPatience) const {
    if (!worker.ok()) {
      PictureResult result = blank(recipe);
      result.state = State::fail;
      result.text = "it does not link: " + worker.error;
      return result;
    }
    return try_picture(config_, builder_, request_,
                       {recipe, *task.config, worker, content, integrated, stages, patience});
  }

  void put(Judged& task, const PictureResult& found) {
    const std::lock_guard lock(mutex_);
    for (PictureResult& picture : task.result.pictures) {
      if (picture.recipe == found.recipe) picture = found;
    }
  }

  static void enter_state(TaskResult& result) {
    if (result.state != State::pass && result.state != State::blocked) return;
    for (const State state : {State::crash, State::timeout, State::fail, State::too_noisy}) {
      for (const PictureResult& picture : result.pictures) {
        if (picture.state == state) result.state = state;
        if (picture.state == state) return;
      }
    }
  }

  const Config& config_;
  const Builder& builder_;
  const GradeRequest& request_;
  std::vector<Judged>& judged_;
  std::vector<Recipe> recipes_;
  std::vector<Exhibit> exhibits_;
  Built together_;
  std::map<std::string, Built> alone_;  // by slug
  std::string content_;                 // of all tasks that are right by themselves
  std::mutex mutex_;
};

}  // namespace

void judge_pictures(const Config& config, const Builder& builder, const GradeRequest& request,
                    std::vector<Judged>& judged, const std::function<void()>& progress) {
  Gallery(config, builder, request, judged).run(progress);
}

}  // namespace grader
