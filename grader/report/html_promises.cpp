#include "grader/report/html_promises.h"

#include "grader/report/filled.h"
#include "grader/report/html_picture.h"
#include "grader/results/order.h"
#include "grader/results/readable.h"
#include "grader/results/summary.h"

#include <algorithm>

#include <fmt/format.h>

namespace grader::report {

namespace {

using kainjow::mustache::data;
using Promises = std::vector<const results::PromiseResult*>;

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
  out.set("integrated", failure.integrated);
  return out;
}

// A bonus promise that is not kept is not a fault; nor is a promise of a task that was not written.
results::State state_of(const results::TaskResult& task, const results::PromiseResult& promise) {
  if (promise.held) return results::State::pass;
  if (!results::is_judged(task, promise)) return results::State::not_judged;
  return promise.bonus || !results::is_fault(task.state) ? results::State::not_attempted
                                                         : results::State::fail;
}

// Nothing can be said of a promise that the lines above it do not say: the task's reason, or that these promises are not judged yet.
bool is_plain(const results::TaskResult& task, const results::PromiseResult& promise,
              results::State state) {
  return promise.failures.empty() && (!task.reason.empty() || state == results::State::not_judged);
}

// One input is in sight; the others are folded. The commands of a task are the same for each of its failures, so only the
// promise that leads has them.
data failures_data(const results::TaskResult& task, const results::PromiseResult& promise,
                   bool leads) {
  data failures{data::type::list};
  for (std::size_t i = 0; i < promise.failures.size(); ++i) {
    data failure = failure_data(promise.failures[i]);
    const bool has_commands = leads && i == 0;
    set_text(failure, "replay", has_commands ? promise.failures[i].replay : "");
    set_text(failure, "see_it", has_commands ? results::how_to_look(task) : "");
    const std::size_t more = promise.failures.size() - 1;
    set_text(failure, "more_inputs",
             i == 1 ? fmt::format("{} more input{}", more, more == 1 ? "" : "s") : "");
    failures.push_back(failure);
  }
  return failures;
}

data promise_data(const results::TaskResult& task, const results::PromiseResult& promise,
                  bool leads) {
  const results::State state = state_of(task, promise);
  data out;
  out.set("promise_words", promise.words.empty() ? promise.name : promise.words);
  out.set("bonus", promise.bonus);
  out.set("promise_tone", tone(state));
  out.set("promise_symbol", results::symbol(state));
  out.set("promise_state", state == results::State::fail         ? "not kept"
                           : state == results::State::not_judged ? "not judged"
                                                                 : "not kept yet");
  out.set("promise_open", leads);
  out.set("failures", failures_data(task, promise, leads));
  out.set("has_inputs_folded", promise.failures.size() > 1);
  out.set("is_plain", is_plain(task, promise, state));
  out.set("no_failures",
          promise.failures.empty() ? data("There is no input to show.") : data(false));
  return out;
}

// The line above the promises that are folded: "13 more promises fail; work on this one".
std::string fold_text(const results::TaskResult& task, const Promises& folded, bool one_leads) {
  const auto fails = std::ranges::count_if(folded, [&](const results::PromiseResult* each) {
    return state_of(task, *each) == results::State::fail;
  });
  if (one_leads && fails > 0) {
    return fmt::format("{} more promise{}; work on this one", fails,
                       fails == 1 ? " fails" : "s fail");
  }
  const bool unknown = state_of(task, *folded[0]) == results::State::not_judged;
  return fmt::format("{} promise{} not {}", folded.size(), folded.size() == 1 ? " is" : "s are",
                     unknown ? "judged yet" : "kept yet");
}

}  // namespace

bool has_leading_promise(const results::TaskResult& task) {
  const Promises broken = results::by_importance(task);
  if (broken.empty() || broken[0]->failures.empty()) return false;
  return state_of(task, *broken[0]) == results::State::fail || !results::missed_bonus(task).empty();
}

void set_promises(data& out, const results::TaskResult& task) {
  data promises{data::type::list}, kept{data::type::list};
  const Promises broken = results::by_importance(task);
  const std::size_t shown = has_leading_promise(task) ? 1 : 0;
  const Promises folded(broken.begin() + static_cast<std::ptrdiff_t>(shown), broken.end());
  for (std::size_t i = 0; i < broken.size(); ++i) {
    data promise = promise_data(task, *broken[i], i < shown);
    set_text(promise, "fold", i == shown ? fold_text(task, folded, shown > 0) : "");
    promises.push_back(promise);
  }
  std::size_t number = 0;
  for (const results::PromiseResult& each : task.promises) {
    if (each.held) kept.push_back(promise_data(task, each, false));
    number += each.held ? 1 : 0;
  }
  out.set("promises", promises);
  out.set("has_promises_folded", !folded.empty());
  out.set("kept", kept);
  out.set("has_kept", number > 0);
  out.set("kept_text", fmt::format("{} promise{} kept", number, number == 1 ? " is" : "s are"));
}

}  // namespace grader::report
