#include "grader/report/gradescope.h"

#include "grader/report/terminal.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace grader::report {

namespace {

using nlohmann::ordered_json;

// "7 of 7 promises are kept, 2 of 3 pictures are right, 1 is not judged yet"
std::string counts_of(const results::TaskResult& task) {
  const auto not_judged = [](int count) {
    return count == 0 ? ""
                      : fmt::format(", {} {} not judged yet", count, count == 1 ? "is" : "are");
  };
  int kept = 0, right = 0, promises_left = 0, pictures_left = 0;
  for (const results::PromiseResult& promise : task.promises) {
    kept += promise.held ? 1 : 0;
    promises_left += results::is_judged(task, promise) ? 0 : 1;
  }
  for (const results::PictureResult& picture : task.pictures) {
    right += picture.state == results::State::pass ? 1 : 0;
    pictures_left += picture.state == results::State::not_judged ? 1 : 0;
  }
  std::string text = fmt::format("{} of {} promises are kept{}", kept, task.promises.size(),
                                 not_judged(promises_left));
  if (!task.pictures.empty()) {
    text += fmt::format("; {} of {} pictures are right{}", right, task.pictures.size(),
                        not_judged(pictures_left));
  }
  return text;
}

std::string output_of(const results::TaskResult& task) {
  std::string text =
      fmt::format("{} {}\n", results::symbol(task.state), results::words(task.state));
  for (const FailureText& failure : failure_texts(task, {})) text += failure.text;
  if (!results::is_fault(task.state) && !task.reason.empty()) text += task.reason + "\n";
  if (task.state == results::State::blocked) {
    text += fmt::format("It waits for {}.\n", fmt::join(task.blocked_by, ", "));
  }
  if (task.state == results::State::not_judged) {
    text += "A promise or picture that is not judged yet has no points, even if it is right.\n";
  }
  return text + "\n" + counts_of(task) + ".\n";
}

// A task that waits for another task and has all its points is right as far as we know: red would
// say that it is wrong.
bool shows_green(const results::TaskResult& task) {
  return task.state == results::State::pass ||
         (task.state == results::State::blocked && task.points >= task.max_points);
}

ordered_json test_of(const results::TaskResult& task) {
  return {{"score", task.points + task.bonus_points},
          {"max_score", task.max_points},
          {"status", shows_green(task) ? "passed" : "failed"},
          {"name", task.slug},
          {"number", task.number},
          {"output", output_of(task)},
          {"output_format", "text"},
          {"tags", {task.part}},
          {"visibility", "visible"},
          {"extra_data", {{"state", name(task.state)}, {"bonus_points", task.bonus_points}}}};
}

std::string head(const results::Results& results) {
  std::string text = results.complete ? "" : fmt::format("{}\n", results::kStopped);
  text += results::verdict(results) + "\n";
  text += fmt::format("Seed {}, {}. Isolation {}.\n", results.seed, results::times(results),
                      results.isolation);
  for (const std::string& version : results.versions) text += version + "\n";
  return text;
}

}  // namespace

std::string to_gradescope(const results::Results& raw) {
  const results::Results results = results::presentable(raw);
  ordered_json tests = ordered_json::array();
  for (const results::TaskResult& task : results.tasks) tests.push_back(test_of(task));
  const results::Totals all = results::totals(results.tasks);
  const ordered_json whole{
      {"score", all.points + all.bonus_points},
      {"execution_time", std::lround(results.seconds)},
      {"output", head(results)},
      {"output_format", "text"},
      {"visibility", "visible"},
      {"stdout_visibility", "hidden"},
      {"tests", tests},
      {"extra_data", {{"complete", results.complete}, {"seed", results.seed}}}};
  return whole.dump(2) + "\n";
}

}  // namespace grader::report
