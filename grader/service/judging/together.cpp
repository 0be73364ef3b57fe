#include "grader/service/judging/together.h"

#include "grader/base/files.h"
#include "grader/base/parallel.h"
#include "grader/service/build/cache.h"
#include "grader/service/process/run_command.h"
#include "grader/tasks.h"
#include "pt/error.h"

#include <algorithm>
#include <mutex>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::judging {

namespace {

const Judged* right_alone(const std::vector<Judged>& judged, const std::string& slug) {
  for (const Judged& each : judged) {
    if (each.config->slug == slug && each.right_alone) return &each;
  }
  return nullptr;
}

class Integration {
 public:
  Integration(const build::Config& config, const build::Builder& builder,
              const GradeRequest& request, std::vector<Judged>& judged,
              const std::function<void()>& progress)
      : config_(config),
        builder_(builder),
        request_(request),
        judged_(judged),
        progress_(progress) {}

  void run() {
    for (Judged& each : judged_) {
      if (request_.dialect && works_only_with_its_own(each)) {
        door::works_only_together(*request_.dialect, replay_command(request_, each.config->slug),
                                  each.result);
        each.right_alone = each.result.state == results::State::pass;
      }
    }
    std::vector<Judged*> together;
    for (Judged& each : judged_) {
      if (each.result.state == results::State::pass && !needs(each.config->slug).empty() &&
          !block(each)) {
        together.push_back(&each);
      }
    }
    if (!together.empty()) judge_all(together);
    for (Judged& each : judged_) each.settled = true;
  }

 private:
  // Returns whether a task that fails with the judge's version of another one keeps all promises with
  // the submission's own.
  bool works_only_with_its_own(const Judged& judged) const {
    const auto adapter = request_.dialect->adapters.find(judged.config->slug);
    if (adapter == request_.dialect->adapters.end() || adapter->second.together.empty() ||
        judged.right_alone || !judged.object.ok() ||
        judged.result.state == results::State::not_attempted)
      return false;
    std::vector<Judged> both = judged_;
    for (Judged& each : both) {
      const std::string& slug = each.config->slug;
      each.right_alone =
          each.object.ok() && (slug == judged.config->slug || slug == adapter->second.together);
    }
    const build::Built worker = link_together(config_, builder_, both, Elsewhere::answers);
    if (!worker.ok()) return false;
    const results::TaskResult found =
        try_worker(builder_, {*judged.config, worker, true, request_, {}});
    return !found.promises.empty() &&
           std::ranges::all_of(found.promises, [&](const results::PromiseResult& promise) {
             const auto& all = judged.result.promises;
             const auto listed =
                 std::ranges::find(all, promise.name, &results::PromiseResult::name);
             return promise.held || listed == all.end() || listed->bonus;
           });
  }

  // A task that was not requested matters only if a requested task fails: it may fail because of
  // the other task, and is then blocked.
  void judge_all(std::vector<Judged*> together) {
    const build::Built worker = link_together(config_, builder_, judged_, Elsewhere::answers);
    const auto others =
        std::stable_partition(together.begin(), together.end(), [&](const Judged* each) {
          return std::ranges::count(request_.asked, each->config->slug) > 0;
        });
    const std::vector<Judged*> asked(together.begin(), others);
    judge_each(asked, worker);
    if (std::ranges::all_of(asked, passes)) return;
    judge_each({others, together.end()}, worker);
    std::erase_if(together, [&](Judged* each) { return block_by_failed(*each, together); });
    base::for_each(together.size(), request_.threads, [&](std::size_t i) { blame(*together[i]); });
  }

  static bool passes(const Judged* judged) { return judged->result.state == results::State::pass; }

  void judge_each(const std::vector<Judged*>& tasks, const build::Built& worker) {
    std::mutex mutex;
    base::for_each(tasks.size(), request_.threads, [&](std::size_t k) {
      const std::size_t i = base::from_both_ends(k, tasks.size());
      Judged found = *tasks[i];  // a copy, as other threads report the original meanwhile
      judge(found, worker);
      found.settled = passes(&found);
      const std::lock_guard lock(mutex);
      *tasks[i] = std::move(found);
      progress_();
    });
  }

  void block(Judged& judged, const std::vector<std::string>& by) const {
    judged.settled = true;
    judged.result.state = results::State::blocked;
    judged.result.blocked_by = by;
    judged.result.reason =
        fmt::format("right by itself; it will be judged with your own tasks as soon as {} {}",
                    fmt::join(by, ", "), by.size() == 1 ? "passes" : "pass");
  }

  bool block(Judged& judged) const {
    std::vector<std::string> by;
    for (const std::string& slug : needs(judged.config->slug)) {
      if (!right_alone(judged_, slug)) by.push_back(slug);
    }
    if (!by.empty()) block(judged, by);
    return !by.empty();
  }

  // A task that fails because a task that it calls fails in the same way is blocked.
  bool block_by_failed(Judged& judged, const std::vector<Judged*>& together) const {
    if (judged.result.state == results::State::pass) return true;
    std::vector<std::string> by;
    for (const std::string& slug : needs(judged.config->slug)) {
      for (const Judged* other : together) {
        const bool fails = other->result.state != results::State::pass;
        if (other->config->slug == slug && fails) by.push_back(slug);
      }
    }
    if (!by.empty()) block(judged, by);
    return !by.empty();
  }

  void judge(Judged& judged, const build::Built& worker) const {
    if (!worker.ok()) {
      judged.result.state = results::State::fail;
      judged.result.reason = "it does not link together with your other tasks";
      judged.result.compiler_output = worker.error;
      return;
    }
    enter(try_worker(builder_, {*judged.config, worker, true, request_, {}}), request_,
          judged.result);
  }

  void blame(Judged& judged) const {
    if (!judged.result.reason.empty()) return;  // it was not judged
    std::vector<std::string> failed;
    for (const results::PromiseResult& promise : judged.result.promises) {
      if (!promise.held && !promise.bonus) failed.push_back(promise.name);
    }
    for (const std::string& slug : needs(judged.config->slug)) {
      const build::Built worker =
          link_together(config_, builder_, judged_, Elsewhere::answers, slug);
      if (!worker.ok()) continue;
      const results::TaskResult found =
          try_worker(builder_, {*judged.config, worker, true, request_, failed});
      const bool corrected =
          !found.promises.empty() &&
          std::all_of(found.promises.begin(), found.promises.end(),
                      [](const results::PromiseResult& promise) { return promise.held; });
      if (corrected) judged.result.blamed.push_back(slug);
    }
    judged.result.reason = judged.result.blamed.empty()
                               ? "right by itself; it fails only together with your other tasks"
                               : fmt::format("right by itself; it fails only with your {}",
                                             fmt::join(judged.result.blamed, " or "));
  }

  const build::Config& config_;
  const build::Builder& builder_;
  const GradeRequest& request_;
  std::vector<Judged>& judged_;
  const std::function<void()>& progress_;
};

}  // namespace

// A task that is not right alone must not spoil other tasks.
build::Built link_together(const build::Config& config, const build::Builder& builder,
                           const std::vector<Judged>& judged, Elsewhere elsewhere,
                           const std::string& swapped) {
  build::Paths objects, own_objects;
  std::string key;
  const auto add = [&](const build::Paths& paths) {
    for (const std::string& path : paths) {
      objects.push_back(path);
      key += build::content_stamp(path, builder.cache());
    }
  };
  for (const build::TaskConfig& task : config.tasks) {
    const Judged* own = right_alone(judged, task.slug);
    if (own != nullptr && task.slug != swapped) {
      own_objects.push_back(own->object.path);
      key += own->object.key;
    } else {
      add(task.reference);
    }
  }
  add(elsewhere == Elsewhere::answers ? config.callbacks.at("radiance") : config.radiance);
  // The submission comes last: if objects share inline functions, the linker takes the first ones.
  objects.insert(objects.end(), own_objects.begin(), own_objects.end());
  // Pictures do not need the counts of tested boxes and primitives, and counting takes time.
  return builder.link(objects, key, elsewhere == Elsewhere::answers);
}

void judge_together(const build::Config& config, const build::Builder& builder,
                    const GradeRequest& request, std::vector<Judged>& judged,
                    const std::function<void()>& progress) {
  Integration(config, builder, request, judged, progress).run();
}

void judge_ahead(const build::Config& config, const build::Builder& builder,
                 const GradeRequest& request, std::vector<Judged> judged,
                 const std::atomic<bool>& stop) {
  if (request.asked.size() != 1 || needs(request.asked[0]).empty() || stop) return;
  const auto asked = std::ranges::find(judged, request.asked[0],
                                       [](const Judged& each) { return each.config->slug; });
  if (!asked->object.ok()) return;
  asked->right_alone = true;
  if (!std::ranges::all_of(judged, &Judged::right_alone)) return;
  try {
    const build::Built worker = link_together(config, builder, judged, Elsewhere::answers);
    if (worker.ok()) try_worker(builder, {*asked->config, worker, true, request, {}, &stop});
    if (request.pictures) link_together(config, builder, judged, Elsewhere::reference);
  } catch (const process::Stopped&) {
    return;
  } catch (const pt::Error&) {
    return;  // if it matters, it comes again and is reported then
  }
}

}  // namespace grader::judging
