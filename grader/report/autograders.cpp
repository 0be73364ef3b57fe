#include "grader/report/autograders.h"

#include "grader/report/terminal.h"
#include "grader/results/points.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <tinyxml2.h>

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

// PrairieLearn takes 1 MB. In JSON a character may need two bytes more.
std::string short_output_of(const results::TaskResult& task) {
  constexpr std::size_t kMaxOutput = 24 << 10;
  std::string text = output_of(task);
  if (text.size() <= kMaxOutput) return text;
  text.resize(text.rfind('\n', kMaxOutput));
  return text + "\n(The rest is left out.)\n";
}

// The text about a promise or a picture that did not earn its points.
std::string reason_of(const results::TaskResult& task, const std::string& promise) {
  for (const FailureText& each : failure_texts(task, {false, true})) {
    if (!promise.empty() && each.promise == promise) return each.text;
  }
  return task.reason.empty() ? results::words(task.state) : task.reason;
}

void print_case(tinyxml2::XMLPrinter& xml, const std::string& name, bool has_points,
                const std::string& reason) {
  xml.OpenElement("testcase");
  xml.PushAttribute("name", name.c_str());
  if (!has_points) {
    xml.OpenElement("failure");
    xml.PushText(reason.c_str());
    xml.CloseElement();
  }
  xml.CloseElement();
}

void print_task(tinyxml2::XMLPrinter& xml, const results::TaskResult& task) {
  for (const results::PromiseResult& each : task.promises) {
    const bool has_points = results::is_kept_by_itself(each);
    if (!has_points && each.bonus) continue;
    print_case(xml, task.slug + " " + each.name, has_points, reason_of(task, each.name));
  }
  for (const results::PictureResult& each : task.pictures) {
    const std::string reason = each.text.empty() ? reason_of(task, "") : each.text;
    print_case(xml, task.slug + " picture " + each.recipe, each.points == each.max_points, reason);
  }
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

std::string to_prairielearn(const results::Results& raw) {
  const results::Results results = results::presentable(raw);
  ordered_json tests = ordered_json::array();
  for (const results::TaskResult& task : results.tasks) {
    tests.push_back({{"name", task.number + " " + task.slug},
                     {"points", task.points},
                     {"max_points", task.max_points},
                     {"output", short_output_of(task)}});
  }
  const results::Totals all = results::totals(results.tasks);
  // PrairieLearn shows a test as wrong if it has more points than its maximum.
  if (all.bonus_points > 0) {
    tests.push_back(
        {{"name", "bonus"}, {"points", all.bonus_points}, {"max_points", all.bonus_points}});
  }
  const double share = (all.points + all.bonus_points) / std::max(1.0, 1.0 * all.max_points);
  const ordered_json whole{{"gradable", true},
                           {"score", std::min(1.0, share)},
                           {"output", head(results)},
                           {"tests", tests}};
  return whole.dump(2) + "\n";
}

std::string to_autolab(const results::Results& raw) {
  const results::Results results = results::presentable(raw);
  ordered_json stages{{"_presentation", "semantic"}, {"stages", ordered_json::array()}};
  ordered_json scores = ordered_json::object();
  std::string text = head(results);
  for (const results::TaskResult& task : results.tasks) {
    text += fmt::format("\n{} {}: {}", task.number, task.slug, output_of(task));
    if (!stages.contains(task.part)) stages["stages"].push_back(task.part);
    ordered_json& shown = stages[task.part][task.slug];
    shown["passed"] = shows_green(task);
    if (!shows_green(task)) shown["hint"] = counts_of(task);
    scores[task.slug] = task.points + task.bonus_points;
  }
  return text + "\n" + stages.dump() + "\n" + ordered_json{{"scores", scores}}.dump() + "\n";
}

std::string to_artemis(const results::Results& raw) {
  const results::Results results = results::presentable(raw);
  tinyxml2::XMLPrinter xml;
  xml.PushHeader(false, true);
  xml.OpenElement("testsuite");
  xml.PushAttribute("name", "Firstlight");
  for (const results::TaskResult& task : results.tasks) print_task(xml, task);
  if (!results.complete) print_case(xml, "the run ends", false, results::kStopped);
  xml.CloseElement();
  return std::string(xml.CStr()) + "\n";
}

}  // namespace grader::report
