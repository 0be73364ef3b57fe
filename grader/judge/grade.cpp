#include "grader/judge/grade.h"

#include "grader/judge/integration.h"
#include "grader/judge/isolation.h"
#include "pt/error.h"

#include <algorithm>
#include <chrono>
#include <set>

namespace grader {

namespace {

using Clock = std::chrono::steady_clock;

// The tasks asked for and all that they need, in the order of the course.
std::vector<const TaskConfig*> to_judge(const Config& config, const GradeRequest& request) {
  std::set<std::string> wanted(request.asked.begin(), request.asked.end());
  for (const std::string& slug : request.asked) {
    wanted.insert(needs(slug).begin(), needs(slug).end());
  }
  std::vector<const TaskConfig*> tasks;
  for (const TaskConfig& task : config.tasks) {
    if (wanted.contains(task.slug)) tasks.push_back(&task);
  }
  return tasks;
}

Results summary(const Config& config, const GradeRequest& request,
                const std::vector<Judged>& judged, Clock::time_point start) {
  Results results;
  results.submission = request.submission;
  results.seed = request.seed;
  results.isolation = request.isolation.words;
  for (const TaskConfig& task : config.tasks) {
    if (std::find(request.asked.begin(), request.asked.end(), task.slug) == request.asked.end()) {
      continue;
    }
    results.asked.push_back(task.slug);
    for (const Judged& each : judged) {
      if (each.config->slug == task.slug) results.tasks.push_back(each.result);
    }
  }
  for (TaskResult& task : results.tasks) count_points(task);
  results.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return results;
}

}  // namespace

Results grade(const Config& config, const GradeRequest& request,
              const std::function<void(const Results&)>& progress) {
  const auto start = Clock::now();
  const Builder builder(config, request.isolation.tier, request.compile_limit);
  std::vector<Judged> judged;
  for (const TaskConfig* task : to_judge(config, request)) {
    if (task->graded.empty()) {
      throw pt::Error(task->slug + " has no properties: nothing about it can be judged");
    }
    judged.push_back({task, {}, {}});
  }
  judge_alone(config, builder, request, judged);
  progress(summary(config, request, judged, start));
  judge_together(config, builder, request, judged);
  Results results = summary(config, request, judged, start);
  results.complete = true;
  progress(results);
  return results;
}

std::vector<std::string> tasks_meant(const Config& config, const std::string& word) {
  std::vector<std::string> slugs;
  for (const TaskConfig& task : config.tasks) {
    const bool meant = word == task.slug || word == task.number || word == task.part ||
                       word == task.part.substr(0, task.part.find('_'));
    if (meant) slugs.push_back(task.slug);
  }
  if (slugs.empty()) {
    throw pt::Error("'" + word +
                    "' is no task and no part: write a name like hit_triangle, or a "
                    "part like 1");
  }
  return slugs;
}

}  // namespace grader
