#include "grader/watch/verdicts.h"

#include "grader/results/summary.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace grader::watch {

Verdicts::Verdicts(const std::vector<build::TaskConfig>& tasks, std::string folder,
                   report::TerminalStyle style)
    : tasks_(tasks), folder_(std::move(folder)), style_(style) {}

void Verdicts::update(const results::Results& results) {
  std::vector<results::TaskResult> merged;
  for (const build::TaskConfig& task : tasks_) {
    const auto same = [&](const results::TaskResult& other) { return other.slug == task.slug; };
    const auto fresh = std::find_if(results.tasks.begin(), results.tasks.end(), same);
    const auto old = std::find_if(known_.tasks.begin(), known_.tasks.end(), same);
    if (fresh != results.tasks.end()) {
      merged.push_back(*fresh);
    } else if (old != known_.tasks.end()) {
      merged.push_back(*old);
    }
  }
  known_.tasks = std::move(merged);
}

std::string Verdicts::bar() const {
  const results::Totals all = results::totals(known_.tasks);
  std::string bar(tasks_.size(), '.');
  std::fill_n(bar.begin(), all.passed, '#');
  return fmt::format("[{}] {} of {} tasks pass", bar, all.passed, tasks_.size());
}

bool Verdicts::all_pass() const {
  return results::totals(known_.tasks).passed == static_cast<int>(tasks_.size());
}

std::string Verdicts::list() const {
  std::string text;
  for (const build::TaskConfig& task : tasks_) {
    const results::TaskResult* result = find(task.slug);
    std::string state = result == nullptr ? "not judged yet" : name(result->state);
    std::replace(state.begin(), state.end(), '_', ' ');
    text += fmt::format("  {}  {:<18} {:<15} {}\n", task.number, task.slug, state, place_of(task));
  }
  return text;
}

std::string Verdicts::state(const std::string& slug) const {
  const results::TaskResult* result = find(slug);
  return result == nullptr ? "" : name(result->state);
}

std::string Verdicts::how_to_look(const std::string& slug) const {
  const results::TaskResult* task = find(slug);
  if (task == nullptr || task->pictures.empty()) return "";
  const auto tells = [](const results::PictureResult& picture) {
    return results::is_fault(picture.state) ? 1 + !picture.cells.empty() : 0;
  };
  return results::how_to_look(slug, *std::ranges::max_element(task->pictures, {}, tells));
}

std::string Verdicts::show(const std::string& slug) {
  const std::string before = this->slug();
  for (std::size_t i = 0; i < tasks_.size(); ++i) {
    if (tasks_[i].slug == slug) task_ = i;
  }
  item_ = 0;
  promise_.clear();
  const std::vector<report::FailureText> all = items(task_);
  if (!all.empty()) return show_item(all[0]);
  const results::TaskResult* result = find(slug);
  if (result == nullptr) return "";
  if (const results::TaskResult* blocker = first_blocker(*result)) {
    return fmt::format("{} is blocked: correct {} first.\n", slug, blocker->slug) +
           show(blocker->slug);
  }
  // If several files are saved at once, the failure of one must not give way to what comes next.
  const results::TaskResult* shown = find(before);
  const bool stays = before != slug && shown != nullptr && results::is_fault(shown->state);
  return slug + " passes.\n" + (stays ? show(before) : show_first());
}

std::string Verdicts::show_first() {
  for (const results::TaskResult& task : known_.tasks) {
    if (results::is_fault(task.state)) return show(task.slug);
  }
  return next();
}

std::string Verdicts::next() {
  for (std::size_t tried = 0; tried <= tasks_.size(); ++tried) {
    const std::vector<report::FailureText> all = items(task_);
    if (item_ < all.size()) return show_item(all[item_]);
    task_ = (task_ + 1) % tasks_.size();
    item_ = 0;
  }
  promise_.clear();
  return "\nNothing is left to do: all tasks pass. ./run grade judges the pictures too.\n";
}

bool Verdicts::is_clone(const std::string& slug) const {
  const results::TaskResult* result = find(slug);
  return result != nullptr && !result->called.empty();
}

// The file of the task or, in a clone of the course's skeleton, its function.
std::string Verdicts::place_of(const build::TaskConfig& task) const {
  return is_clone(task.slug) ? find(task.slug)->called : folder_ + "/" + task.file();
}

const results::TaskResult* Verdicts::find(const std::string& slug) const {
  for (const results::TaskResult& task : known_.tasks) {
    if (task.slug == slug) return &task;
  }
  return nullptr;
}

// The first task that has to be corrected before a blocked task; null if the task is not blocked.
const results::TaskResult* Verdicts::first_blocker(const results::TaskResult& task) const {
  if (task.state != results::State::blocked) return nullptr;
  for (const std::string& slug : task.blocked_by) {
    const results::TaskResult* blocker = find(slug);
    if (blocker != nullptr && results::is_fault(blocker->state)) return blocker;
  }
  return nullptr;
}

// The failures of a task that remain to be corrected: none if it passes, or is blocked by a task
// whose failures are shown instead.
std::vector<report::FailureText> Verdicts::items(std::size_t task) const {
  const build::TaskConfig& config = tasks_[task];
  const results::TaskResult* result = find(config.slug);
  if (result != nullptr &&
      (result->state == results::State::pass || first_blocker(*result) != nullptr)) {
    return {};
  }
  if (result == nullptr || result->state == results::State::not_attempted) {
    return {
        {config.slug, "",
         fmt::format("\n{} {} is not {} yet.\n  contract  pt/tasks/{}.h\n  {:<8}  {}\n",
                     config.number, config.slug, result == nullptr ? "judged" : "written",
                     config.slug, is_clone(config.slug) ? "function" : "file", place_of(config))}};
  }
  std::vector<report::FailureText> all = report::failure_texts(*result, style_);
  if (all.empty()) {
    all.push_back(
        {config.slug, "",
         fmt::format("\n{}: {}. {}\n", config.slug, name(result->state), result->reason)});
  }
  return all;
}

std::string Verdicts::show_item(const report::FailureText& item) {
  ++item_;
  promise_ = item.promise;
  const std::size_t count = items(task_).size();
  if (count == 1) return item.text;
  return item.text + fmt::format("  failure   {} of {}\n", item_, count);
}

}  // namespace grader::watch
