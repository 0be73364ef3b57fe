#include "grader/tasks.h"

#include "pt/error.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

namespace grader {

namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

// A word that nobody reads would do nothing, so it is an error.
constexpr std::array kWords{"slug",      "number", "part",     "functions", "calls",
                            "framework", "mocks",  "recorded", "viewed",    "judge_answers",
                            "traces",    "tracer", "measured"};

// Functions of the renderer that every task may call that traces.
constexpr std::array kScene{"pt::Scene::closest", "pt::Scene::occluded", "pt::surface_point",
                            "pt::background", "pt::sample_light"};

Task read_task(const json& from) {
  Task task;
  for (const auto& [word, value] : from.items()) {
    if (std::ranges::find(kWords, word) == kWords.end()) {
      throw pt::Error("grader/tasks/" + from.at("slug").get<std::string>() +
                      "/task.json has the word '" + word + "', which grader/tasks.h does not know");
    }
  }
  from.at("slug").get_to(task.slug);
  from.at("number").get_to(task.number);
  from.at("part").get_to(task.part);
  task.functions = from.value("functions", Names{task.slug});
  task.calls = from.value("calls", Names{});
  task.judge_answers = from.value("judge_answers", Names{});
  task.mocks = from.value("mocks", Names{});
  task.traces = from.value("traces", false);
  task.framework = from.value("framework", Names{});
  if (task.traces) task.framework.insert(task.framework.end(), kScene.begin(), kScene.end());
  if (std::ranges::count(task.judge_answers, "radiance") > 0) {
    task.framework.push_back("pt::radiance");
  }
  return task;
}

std::vector<Task> read_tasks() {
  const json all = json::parse(tasks_json);
  std::vector<Task> tasks;
  for (const json& each : all.at("tasks")) tasks.push_back(read_task(each));
  return tasks;
}

// Through these a scene is traced.
const Names& tracers() {
  static const Names all = [] {
    Names slugs;
    const json table = json::parse(tasks_json);
    for (const json& each : table.at("tasks")) {
      if (each.value("tracer", false)) slugs.push_back(each.at("slug"));
    }
    return slugs;
  }();
  return all;
}

void add_needs(const Task& task, std::set<std::string>& needed) {
  Names calls = task.calls;
  if (task.traces) calls.insert(calls.end(), tracers().begin(), tracers().end());
  for (const std::string& slug : calls) {
    if (needed.insert(slug).second) add_needs(task_of(slug), needed);
  }
}

Names find_tracing_tasks() {
  std::set<std::string> found(tracers().begin(), tracers().end());
  for (const std::string& slug : tracers()) add_needs(task_of(slug), found);
  Names all;
  for (const Task& task : tasks()) {
    if (found.contains(task.slug)) all.push_back(task.slug);
  }
  return all;
}

std::map<std::string, Names, std::less<>> find_needs() {
  std::map<std::string, Names, std::less<>> all;
  for (const Task& task : tasks()) {
    std::set<std::string> needed;
    add_needs(task, needed);
    for (const Task& other : tasks()) {
      if (needed.contains(other.slug)) all[task.slug].push_back(other.slug);
    }
  }
  return all;
}

}  // namespace

const std::vector<Task>& tasks() {
  static const std::vector<Task> all = read_tasks();
  return all;
}

const Task& task_of(std::string_view slug) {
  const auto found = std::ranges::find(tasks(), slug, &Task::slug);
  if (found == tasks().end()) {
    throw pt::Error("'" + std::string(slug) + "' is not a task: see grader/tasks/");
  }
  return *found;
}

const std::vector<std::string>& needs(std::string_view slug) {
  static const auto all = find_needs();
  static const Names none;
  const auto found = all.find(slug);
  return found == all.end() ? none : found->second;
}

const std::vector<std::string>& tracing_tasks() {
  static const Names all = find_tracing_tasks();
  return all;
}

std::filesystem::path mistake_file(const std::filesystem::path& root, const std::string& slug,
                                   const std::string& name, const std::string& made) {
  return root / "build" / made / slug / name / (slug + ".cpp");
}

}  // namespace grader
