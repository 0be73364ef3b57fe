#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace grader {

// The facts about one task of the course: grader/tasks/<slug>/task.json, which the build and the
// script ./run read too. Its functions have the types of the contract (grader/calls.h), its promises are in
// pt/tasks/, the points for these in grader/points.json.
struct Task {
  std::string slug;                      // "hit_triangle"
  std::string part;                      // "1_rays"
  std::string number;                    // "1.3": the third task of the first part
  std::vector<std::string> functions{};  // of the contract, in namespace pt; by default the slug
  std::vector<std::string> calls{};      // the other tasks that it may call: slugs
  std::vector<std::string>
      judge_answers{};               // calls that the judge answers while it is judged alone
  std::vector<std::string> mocks{};  // tasks that a mock replaces then
  std::vector<std::string>
      framework{};      // functions of the renderer that it may call: "pt::BvhBuilder::leaf"
  bool traces = false;  // it sends rays through a scene, and so through a tree
  // Four more words are not read here. `tracer`: pt/scene/tracer.cpp calls the task. `recorded` and
  // `viewed` are for CMake: calls of the task can be recorded (pt/scene/recorder.h), in all programs
  // that count, or in the view alone. `measured` is for
  // ./run measure (measure/calls/tasks.h).

  std::string file() const { return part + "/" + slug + ".cpp"; }
};

// In the order of the course.
const std::vector<Task>& tasks();

// Throws pt::Error if there is no such task.
const Task& task_of(std::string_view slug);

// The tasks whose code a task's calls reach, in the order of the course: all of them, not only
// those it calls itself. A task that traces needs the `tracers`.
const std::vector<std::string>& needs(std::string_view slug);

// The tasks that a ray through a scene is traced by, in the order of the course: the `tracers` and
// what they need.
const std::vector<std::string>& tracing_tasks();

// The file of a known mistake of a task, which the build makes of mistakes.txt (cmake/mistakes.cmake). `root` is the folder of the
// project; `made` is "relatives" for the relative of the mistake.
std::filesystem::path mistake_file(const std::filesystem::path& root, const std::string& slug,
                                   const std::string& name, const std::string& made = "mistakes");

// The table of all tasks, {"tasks": [...]} in the order of the course: what the task.json of each says, and its slug.
extern const std::string_view tasks_json;

}  // namespace grader
