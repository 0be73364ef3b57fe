#include "grader/report/html.h"

#include "grader/report/filled.h"
#include "grader/report/html_picture.h"
#include "grader/report/page/sources.h"
#include "grader/results/order.h"
#include "grader/results/presentable.h"
#include "grader/results/readable.h"
#include "grader/results/summary.h"

#include <algorithm>

#include <fmt/format.h>

namespace grader::report {

namespace {

using kainjow::mustache::data;

// Sets a text, and whether there is any.
void set_text(data& out, const std::string& key, const std::string& text) {
  out.set(key, text);
  out.set("has_" + key, !text.empty());
}

// Sets a list of objects with one member, `key`. `list` is its name in the template.
void set_texts(data& out, const std::string& list, const std::string& key,
               const std::vector<std::string>& texts) {
  data items{data::type::list};
  for (const std::string& text : texts) items.push_back(data{key, text});
  out.set(list, items);
  out.set("has_" + list, !texts.empty());
}

data failure_data(const results::Failure& exact) {
  const results::Readable readable = results::readable(exact);
  const results::Failure& failure = readable.failure;
  data out;
  set_texts(out, "input", "line", failure.input);
  set_texts(out, "folded", "line", readable.left_out);
  out.set("lines_folded", std::to_string(readable.lines_left_out));
  set_text(out, "what", failure.what);
  set_text(out, "got", failure.got);
  set_text(out, "expected", failure.expected);
  set_text(out, "off_by", failure.off_by);
  set_text(out, "cause", failure.cause == results::Cause::wrong ? "" : name(failure.cause));
  set_text(out, "replay", failure.replay);
  out.set("integrated", failure.integrated);
  out.set("cases_before", std::to_string(failure.cases_before));
  out.set("failure_seed", std::to_string(failure.seed));
  return out;
}

// A bonus promise that is not kept is not a fault; nor is a promise of a task that was not written.
results::State state_of(const results::TaskResult& task, const results::PromiseResult& promise) {
  if (promise.held) return results::State::pass;
  if (!results::is_judged(task, promise)) return results::State::not_judged;
  return promise.bonus || !results::is_fault(task.state) ? results::State::not_attempted
                                                         : results::State::fail;
}

std::string why_no_failures(const results::TaskResult& task, results::State promise) {
  if (!task.reason.empty()) return task.reason;
  return promise == results::State::not_judged ? "It is not judged yet."
                                               : "There is no input to show.";
}

data promise_data(const results::TaskResult& task, const results::PromiseResult& promise) {
  const results::State state = state_of(task, promise);
  data out, failures{data::type::list};
  for (const results::Failure& failure : promise.failures)
    failures.push_back(failure_data(failure));
  out.set("promise_words", promise.words.empty() ? promise.name : promise.words);
  out.set("bonus", promise.bonus);
  out.set("held", promise.held);
  out.set("broken", !promise.held);
  const bool only_a_bonus = promise.bonus && !results::missed_bonus(task).empty();
  out.set("promise_open",
          (state == results::State::fail || only_a_bonus) && !promise.failures.empty());
  out.set("promise_tone", tone(state));
  out.set("promise_symbol", results::symbol(state));
  out.set("promise_state", state == results::State::fail         ? "not kept"
                           : state == results::State::not_judged ? "not judged"
                                                                 : "not kept yet");
  out.set("failures", failures);
  out.set("no_failures",
          promise.failures.empty() ? data(why_no_failures(task, state)) : data(false));
  return out;
}

data task_data(const results::TaskResult& task, Places& places) {
  data out, promises{data::type::list}, pictures{data::type::list};
  // Broken promises first, the most telling at the top.
  for (const results::PromiseResult* each : results::by_importance(task)) {
    promises.push_back(promise_data(task, *each));
  }
  for (const results::PromiseResult& each : task.promises) {
    if (each.held) promises.push_back(promise_data(task, each));
  }
  for (const results::PictureResult& each : task.pictures) {
    pictures.push_back(picture_data(each, task.slug, places));
  }
  out.set("number", task.number);
  out.set("slug", task.slug);
  set_text(out, "called", task.called);
  out.set("tone", tone(task.state));
  out.set("symbol", results::symbol(task.state));
  out.set("words", results::words(task.state));
  out.set("open", results::is_fault(task.state));
  out.set("task_points", std::to_string(task.points));
  out.set("task_max", std::to_string(task.max_points));
  out.set("task_has_bonus", task.bonus_points > 0);
  out.set("task_bonus", std::to_string(task.bonus_points));
  set_text(out, "missed_bonus", results::missed_bonus_text(task));
  set_text(out, "reason", task.reason);
  set_text(out, "mistake", results::mistake_text(task));
  set_text(out, "spared", results::spared_text(task));
  set_texts(out, "blocked_by", "other", task.blocked_by);
  set_texts(out, "blamed", "other", task.blamed);
  set_text(out, "compiler_output", task.compiler_output);
  set_text(out, "warnings", results::is_fault(task.state) ? task.warnings : "");
  set_text(out, "printed", task.printed);
  out.set("promises", promises);
  out.set("has_promises", !task.promises.empty());
  out.set("pictures", pictures);
  out.set("has_pictures", !task.pictures.empty());
  return out;
}

data parts_data(const std::vector<results::TaskResult>& tasks, PageSize size) {
  Places places(size);
  data parts{data::type::list};
  for (std::size_t i = 0; i < tasks.size();) {
    std::vector<results::TaskResult> of_part;
    data list{data::type::list};
    const std::string& part = tasks[i].part;
    for (; i < tasks.size() && tasks[i].part == part; ++i) {
      of_part.push_back(tasks[i]);
      list.push_back(task_data(tasks[i], places));
    }
    const results::Totals sum = results::totals(of_part);
    data out;
    out.set("part_number", results::part_number(part));
    out.set("part_name", results::part_name(part));
    out.set("part_points", std::to_string(sum.points));
    out.set("part_max", std::to_string(sum.max_points));
    out.set("tasks", list);
    parts.push_back(out);
  }
  return parts;
}

data page_data(const results::Results& results, PageSize size) {
  const results::Totals all = results::totals(results.tasks);
  data out;
  out.set("style", std::string(page_css));
  out.set("script", std::string(page_js));
  out.set("verdict", results::verdict(results));
  out.set("passed", results::passed(results));
  out.set("points", std::to_string(all.points));
  out.set("max_points", std::to_string(all.max_points));
  out.set("has_bonus", all.bonus_points > 0);
  out.set("bonus_points", std::to_string(all.bonus_points));
  const int percent = all.max_points > 0 ? 100 * all.points / all.max_points : 0;
  out.set("percent", std::to_string(std::clamp(percent, 0, 100)));
  out.set("stopped", results.complete ? data(false) : data(results::kStopped));
  out.set("submission", results.submission);
  set_text(out, "dialect", results.dialect);
  out.set("isolation", results.isolation);
  out.set("seed", std::to_string(results.seed));
  out.set("times", results::times(results));
  set_texts(out, "versions", "version", results.versions);
  set_text(out, "command", results.command);
  out.set("parts", parts_data(results.tasks, size));
  return out;
}

}  // namespace

std::string to_html(const results::Results& results, PageSize size) {
  return filled(page_html, page_data(results::presentable(results), size));
}

}  // namespace grader::report
