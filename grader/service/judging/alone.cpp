#include "grader/service/judging/alone.h"

#include "grader/base/files.h"
#include "grader/base/parallel.h"
#include "grader/base/sha256.h"
#include "grader/results/order.h"
#include "grader/results/presentable.h"
#include "grader/results/promises.h"
#include "grader/service/build/cache.h"
#include "grader/service/judging/together.h"
#include "grader/tasks.h"
#include "pt/file.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include <fmt/format.h>

namespace grader::judging {

namespace {

// One entry per promise of the contract, none kept yet. Promises without a property do not count.
std::vector<results::PromiseResult> promises_to_judge(const build::Config& config,
                                                      const std::string& slug) {
  std::vector<results::PromiseResult> promises;
  for (const results::Promise& promise :
       results::promises_of(pt::read_file(config.root + "/pt/tasks/" + slug + ".h"))) {
    results::PromiseResult result;
    result.name = promise.name;
    result.words = promise.title + (promise.words.empty() ? "" : ": " + promise.words);
    result.bonus = promise.bonus;
    promises.push_back(result);
  }
  return promises;
}

void refuse(results::TaskResult& result, results::State state, const std::string& reason,
            const std::string& output = "") {
  result.state = state;
  result.reason = reason;
  result.compiler_output = output;
}

// Compilers print the path that they were given, but people look for the file in the submission.
std::string in_folder(std::string text, const build::TaskConfig& task, const std::string& folder) {
  if (folder.empty()) return text;
  for (std::size_t at = text.find(task.file()); at != std::string::npos;
       at = text.find(task.file(), at + folder.size() + 1 + task.file().size())) {
    text.insert(at, folder + "/");
  }
  return text;
}

// Returns whether the error is in one of our texts around the learner's (grader/door/).
bool is_not_of_course(const std::string& error) {
  return error.starts_with("door/") || error.find("\ndoor/") != error.npos;
}

// The sentence in which an adapter says what is not the course's, or else the compiler's.
std::string not_of_course(const std::string& error) {
  constexpr std::string_view kStated = "static assertion failed: ";
  const std::size_t stated = error.find(kStated), said = error.find("error: ");
  const std::size_t begin = stated != error.npos ? stated + kStated.size()
                            : said != error.npos ? said + std::string_view("error: ").size()
                                                 : 0;
  const std::string words = error.substr(begin, error.find('\n', begin) - begin);
  return "not judged: " + (stated != error.npos ? words : "the code is not the course's: " + words);
}

void compile_one(const build::Builder& builder, const GradeRequest& request, Judged& judged) {
  const build::TaskConfig& task = *judged.config;
  results::TaskResult& result = judged.result;
  const base::Submitted file = base::read_submitted(request.submission, task.part, task.slug);
  if (!file.present)
    return refuse(result, results::State::not_attempted, "there is no " + task.file());
  if (!file.rejected.empty()) return refuse(result, results::State::rejected, file.rejected);
  judged.content = base::sha256(file.text);
  judged.object = builder.compile(task, file.text);
  // In a clone of the course, messages name the learner's own files.
  const std::string folder = request.dialect ? "" : results::one_line(shown_folder(request));
  result.warnings = in_folder(judged.object.warnings, task, folder);
  if (!judged.object.rejected.empty()) {
    return refuse(result, results::State::rejected, judged.object.rejected);
  }
  if (request.dialect && is_not_of_course(judged.object.error)) {
    return refuse(result, results::State::rejected, not_of_course(judged.object.error));
  }
  if (!judged.object.ok()) {
    return refuse(result, results::State::fail, "it does not compile",
                  in_folder(judged.object.error, task, folder));
  }
}

void judge_one(const build::Config& config, const build::Builder& builder,
               const GradeRequest& request, Judged& judged) {
  if (!judged.object.ok()) return;
  const build::TaskConfig& task = *judged.config;
  results::TaskResult& result = judged.result;
  const build::Built worker = link_alone(config, builder, judged, Elsewhere::answers);
  if (!worker.ok()) return refuse(result, results::State::fail, "it does not link", worker.error);
  const results::TaskResult found = try_worker(builder, {task, worker, false, request, {}});
  // Only promises with a property are judged. Another check proves that every promise has one.
  if (!found.promises.empty()) {
    std::erase_if(result.promises, [&](const results::PromiseResult& promise) {
      if (request.dialect && door::is_own(*request.dialect, result.slug, promise.name))
        return false;
      return std::ranges::count(found.promises, promise.name, &results::PromiseResult::name) == 0;
    });
  }
  enter(found, request, result);
  const bool is_judged = found.state != results::State::not_attempted && !found.promises.empty();
  if (request.dialect && is_judged) {
    door::settle_own(*request.dialect, found.printed, replay_command(request, result.slug), result);
    result.state = state_of(result);
  }
  judged.right_alone = result.state == results::State::pass;
}

// The result's entry for a promise, which is made if the contract does not list the promise.
results::PromiseResult& entry(results::TaskResult& result, const results::PromiseResult& found) {
  for (results::PromiseResult& promise : result.promises) {
    if (promise.name == found.name) return promise;
  }
  result.promises.push_back(found);
  result.promises.back().failures.clear();
  result.promises.back().words = found.name;
  return result.promises.back();
}

}  // namespace

void enter(const results::TaskResult& found, const GradeRequest& request,
           results::TaskResult& result) {
  if (!found.printed.empty())
    result.printed = request.dialect ? door::without_notes(found.printed) : found.printed;
  if (found.promises.empty()) {
    for (results::PromiseResult& promise : result.promises) promise.held = false;
  }
  if (found.state == results::State::not_attempted || found.promises.empty())
    return refuse(result, found.state, found.reason);
  for (const results::PromiseResult& each : found.promises) {
    if (request.dialect && door::is_dropped(*request.dialect, result.slug, each.name)) continue;
    results::PromiseResult& promise = entry(result, each);
    if (promise.bonus && !promise.failures.empty()) continue;  // known already
    promise.held = each.held;
    promise.seconds += each.seconds;
    promise.checks = std::max(promise.checks, each.checks);
    for (results::Failure failure : each.failures) {
      failure.replay = replay_command(request, result.slug);
      promise.failures.push_back(failure);
    }
    results::put_most_telling_first(promise.failures);
  }
  if (found.keeps_state) {
    result.keeps_state = true;
    result.reason = found.reason;
  }
  result.state = state_of(result);
}

Judged not_judged(const build::Config& config, const build::TaskConfig& task) {
  Judged judged;
  judged.config = &task;
  judged.result.part = task.part;
  judged.result.number = task.number;
  judged.result.slug = task.slug;
  judged.result.promises = promises_to_judge(config, task.slug);
  return judged;
}

build::Built link_alone(const build::Config& config, const build::Builder& builder,
                        const Judged& judged, Elsewhere elsewhere) {
  build::Paths objects;
  std::string key = judged.object.key;
  const Task& task = task_of(judged.config->slug);
  const auto add = [&](const std::string& name, const build::Paths& reference) {
    const bool answer =
        elsewhere == Elsewhere::answers && (std::ranges::count(task.judge_answers, name) > 0 ||
                                            std::ranges::count(task.mocks, name) > 0);
    for (const std::string& path : answer ? config.callbacks.at(name) : reference) {
      objects.push_back(path);
      key += build::content_stamp(path, builder.cache());
    }
  };
  for (const build::TaskConfig& other : config.tasks) {
    if (other.slug != judged.config->slug) add(other.slug, other.reference);
  }
  add("radiance", config.radiance);
  // The submission comes last: if objects share inline functions, the linker takes the first ones.
  objects.push_back(judged.object.path);
  // If the task calls tasks that trace rays, its record has these calls (grader/explain/record.h).
  const bool is_recorded = elsewhere == Elsewhere::answers &&
                           std::ranges::any_of(task.calls, [](const std::string& other) {
                             return task_of(other).traces;
                           });
  return builder.link(objects, key, is_recorded);
}

void compile_all(const build::Builder& builder, const GradeRequest& request,
                 std::vector<Judged>& judged) {
  base::for_each(judged.size(), request.threads,
                 [&](std::size_t i) { compile_one(builder, request, judged[i]); });
}

void judge_alone(const build::Config& config, const build::Builder& builder,
                 const GradeRequest& request, std::vector<Judged>& judged,
                 const std::function<void()>& progress) {
  std::mutex mutex;
  std::atomic<bool> stop_ahead = false;
  const auto known_so_far = [&] {
    const std::lock_guard lock(mutex);
    return judged;
  };
  base::for_each(judged.size() + 1, request.threads, [&](std::size_t k) {
    if (k == judged.size()) {
      return judge_ahead(config, builder, request, known_so_far(), stop_ahead);
    }
    // A single task that was asked for comes last, and is judged ahead as soon as the others are right.
    const bool is_one = request.asked.size() == 1;
    const std::size_t i = is_one ? k : base::from_both_ends(k, judged.size());
    Judged found = judged[i];  // a copy, as other threads report the original meanwhile
    judge_one(config, builder, request, found);
    if (!found.right_alone) stop_ahead = true;
    // Without a reference, a task may fail because another task does.
    found.settled =
        found.right_alone ? needs(found.config->slug).empty() : config.no_reference.empty();
    const std::lock_guard lock(mutex);
    judged[i] = std::move(found);
    progress();
  });
}

}  // namespace grader::judging
