#include "grader/report/read_json.h"

#include "pt/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader {

namespace {

using nlohmann::json;

State state_of(const std::string& text) {
  for (const State state :
       {State::pass, State::fail, State::crash, State::timeout, State::not_attempted,
        State::blocked, State::too_noisy, State::rejected}) {
    if (text == name(state)) return state;
  }
  throw pt::Error("there is no state '" + text + "'");
}

FailureReport read_failure(const json& from) {
  return {from.at("input"),      from.at("what"),  from.at("got"),          from.at("expected"),
          from.at("off_by"),     from.at("cause"), from.at("cases_before"), from.at("seed"),
          from.at("integrated"), from.at("replay")};
}

PromiseResult read_promise(const json& from) {
  PromiseResult promise;
  from.at("name").get_to(promise.name);
  from.at("words").get_to(promise.words);
  from.at("bonus").get_to(promise.bonus);
  from.at("held").get_to(promise.held);
  from.at("seconds").get_to(promise.seconds);
  for (const json& each : from.at("failures")) promise.failures.push_back(read_failure(each));
  return promise;
}

TaskResult read_task(const json& from) {
  TaskResult task;
  from.at("part").get_to(task.part);
  from.at("number").get_to(task.number);
  from.at("slug").get_to(task.slug);
  task.state = state_of(from.at("state"));
  from.at("reason").get_to(task.reason);
  from.at("points").get_to(task.points);
  from.at("max_points").get_to(task.max_points);
  from.at("bonus_points").get_to(task.bonus_points);
  from.at("blocked_by").get_to(task.blocked_by);
  from.at("blamed").get_to(task.blamed);
  from.at("compiler_output").get_to(task.compiler_output);
  from.at("printed").get_to(task.printed);
  for (const json& each : from.at("promises")) task.promises.push_back(read_promise(each));
  for (const json& each : from.at("pictures")) {
    PictureResult picture;
    picture.recipe = each.at("recipe");
    picture.state = state_of(each.at("state"));
    picture.text = each.at("text");
    task.pictures.push_back(picture);
  }
  return task;
}

Results read_results(const json& from) {
  if (from.at("schema_version") != kSchemaVersion) {
    throw pt::Error(fmt::format("the schema is not version {}", kSchemaVersion));
  }
  Results results;
  from.at("submission").get_to(results.submission);
  from.at("seed").get_to(results.seed);
  from.at("isolation").get_to(results.isolation);
  from.at("seconds").get_to(results.seconds);
  from.at("complete").get_to(results.complete);
  from.at("asked").get_to(results.asked);
  for (const json& each : from.at("tasks")) results.tasks.push_back(read_task(each));
  return results;
}

}  // namespace

Results results_from_json(const std::string& text, const std::string& path) {
  try {
    return read_results(json::parse(text));
  } catch (const std::exception& error) {
    throw pt::Error(path + " holds no results of this grader: " + error.what());
  }
}

}  // namespace grader
