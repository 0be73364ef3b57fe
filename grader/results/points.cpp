#include "grader/results/points.h"

#include "grader/base/json_text.h"
#include "grader/tasks.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace grader::results {

namespace {

using nlohmann::json;

int read_number(const json& from, const std::string& where) {
  if (!from.is_number_unsigned() || from.get<std::uint64_t>() > 1000) {
    throw pt::Error(where + " is not a whole number from 0 to 1000");
  }
  return from.get<int>();
}

double read_share(const json& from, const std::string& where) {
  if (!from.is_number() || !(from.get<double>() >= 0 && from.get<double>() <= 1)) {
    throw pt::Error(where + " is not a number from 0 to 1");
  }
  return from.get<double>();
}

std::map<std::string, int> read_numbers(const json& from, const std::string& where) {
  if (!from.is_object()) throw pt::Error(where + " is not an object");
  std::map<std::string, int> numbers;
  for (const auto& [name, value] : from.items()) {
    numbers[name] = read_number(value, fmt::format("{}.{}", where, name));
  }
  return numbers;
}

TaskPoints read_task(const json& from, TaskPoints points, const std::string& where) {
  if (!from.is_object()) throw pt::Error(where + " is not an object");
  for (const auto& [name, value] : from.items()) {
    const std::string place = fmt::format("{}.{}", where, name);
    if (name == "promise") {
      points.promise = read_number(value, place);
    } else if (name == "picture") {
      points.picture = read_number(value, place);
    } else if (name == "too_noisy") {
      points.too_noisy = read_number(value, place);
    } else if (name == "keeps_state") {
      points.keeps_state = read_number(value, place);
    } else if (name == "examples") {
      points.examples = read_number(value, place);
    } else if (name == "one_cause") {
      points.one_cause = read_share(value, place);
    } else if (name == "promises" || name == "pictures") {
      (name == "promises" ? points.promises : points.pictures) = read_numbers(value, place);
    } else {
      throw pt::Error(place +
                      " means nothing; write promise, picture, too_noisy, keeps_state, "
                      "one_cause, examples, promises or "
                      "pictures");
    }
  }
  return points;
}

// The points of all tasks of the course: by default, except where "tasks" says otherwise.
Points read_tasks(const json& from, const TaskPoints& usual) {
  if (!from.is_object()) throw pt::Error("tasks is not an object");
  Points points;
  std::vector<std::string> slugs;
  for (const Task& task : tasks()) {
    slugs.push_back(task.slug);
    points[task.slug] = usual;
  }
  for (const auto& [slug, task] : from.items()) {
    const auto found = points.find(slug);
    if (found == points.end()) {
      throw pt::Error(
          fmt::format("tasks.{} is not a task; write one of {}", slug, fmt::join(slugs, ", ")));
    }
    found->second = read_task(task, usual, "tasks." + slug);
  }
  return points;
}

void multiply(TaskPoints& points, int weight) {
  for (int* each : {&points.promise, &points.picture, &points.too_noisy, &points.keeps_state,
                    &points.examples}) {
    *each *= weight;
  }
  for (auto* special : {&points.promises, &points.pictures}) {
    for (auto& [name, worth] : *special) worth *= weight;
  }
}

void weigh_parts(const json& parts, Points& points) {
  std::set<std::string> known;
  for (const Task& task : tasks()) known.insert(task.part);
  for (const auto& [part, weight] : read_numbers(parts, "parts")) {
    if (!known.contains(part)) {
      throw pt::Error(fmt::format("parts.{} is not a part of the course; write {}", part,
                                  fmt::join(known, ", ")));
    }
    for (const Task& task : tasks()) {
      if (task.part == part) multiply(points[task.slug], weight);
    }
  }
}

int worth(int usual, const std::map<std::string, int>& special, const std::string& name) {
  const auto found = special.find(name);
  return found == special.end() ? usual : found->second;
}

// The reason for which a promise is broken, if all its failures have the same one: the same end of a call, or the same answer
// to the same input. Empty if there is none.
std::string reason_of(const PromiseResult& promise) {
  std::string reason;
  for (const Failure& failure : promise.failures) {
    if (failure.integrated) continue;
    std::string own = fmt::format("{}: {}", name(failure.cause), failure.got);
    if (failure.cause == Cause::wrong) own += fmt::format("\n{}", fmt::join(failure.input, "\n"));
    if (reason.empty()) reason = own;
    if (reason != own) return "";
  }
  return reason;
}

// The points that promises cost which are broken for the same reason as one that costs as much or more.
int lost_for_the_same_reason(const TaskResult& result) {
  std::map<std::string, int> lost, dearest;
  for (const PromiseResult& promise : result.promises) {
    const std::string reason = reason_of(promise);
    if (promise.bonus || reason.empty() || is_kept_by_itself(promise)) continue;
    lost[reason] += promise.points;
    dearest[reason] = std::max(dearest[reason], promise.points);
  }
  int sum = 0;
  for (const auto& [reason, points] : lost) sum += points - dearest[reason];
  return sum;
}

// The points that broken promises cost beyond the limit for one cause. It is at most what the
// promises that hold are worth, and 0 if the task always gives the same answer: such a task has
// shown nothing, whatever its mistake is called.
int spared_by(const TaskPoints& task, const TaskResult& result) {
  int all = 0, lost = 0, dearest = 0;
  for (const PromiseResult& promise : result.promises) {
    if (promise.bonus) continue;
    all += promise.points;
    const int cost = is_kept_by_itself(promise) ? 0 : promise.points;
    lost += cost;
    dearest = std::max(dearest, cost);
  }
  // In doubles .1 x 30 is a little more than 3: it stands for 3 points.
  const int share = static_cast<int>(std::ceil(task.one_cause * all - 1e-9));
  const bool one_cause = !result.mistake.empty() && !result.mistake.always_the_same &&
                         result.mistake.found_by != kNamedOnly;
  const bool is_proven = result.mistake.found_by == kOneCause;
  if (one_cause && is_proven) return std::max(0, lost - dearest);
  const int more = one_cause ? std::max(0, lost - share) : 0;
  const int again = task.one_cause < 1 ? lost_for_the_same_reason(result) : 0;
  return result.mistake.always_the_same ? 0 : std::min(std::max(more, again), all - lost);
}

}  // namespace

Points load_points(const std::string& path) {
  const json all = base::parse_json(pt::read_file(path), path);
  try {
    if (!all.is_object()) throw pt::Error("it is not an object with default and tasks");
    const TaskPoints usual = read_task(all.at("default"), {}, "default");
    Points points = read_tasks(all.at("tasks"), usual);
    if (all.contains("parts")) weigh_parts(all.at("parts"), points);
    return points;
  } catch (const json::exception& error) {
    throw pt::Error(
        fmt::format("{}: {}; see grader/results/points.h", path, base::words_of(error)));
  } catch (const pt::Error& error) {
    throw pt::Error(fmt::format("{}: {}", path, error.what()));
  }
}

bool is_left_out(const Points& points, const std::string& slug) {
  const auto found = points.find(slug);
  if (found == points.end()) return false;
  const auto earns = [](const auto& special) { return special.second > 0; };
  const TaskPoints& task = found->second;
  return task.promise == 0 && task.picture == 0 && std::ranges::none_of(task.promises, earns) &&
         std::ranges::none_of(task.pictures, earns);
}

bool is_kept_by_itself(const PromiseResult& promise) {
  return promise.held ||
         (!promise.failures.empty() && std::ranges::all_of(promise.failures, &Failure::integrated));
}

void count_points(const Points& points, TaskResult& result) {
  const auto found = points.find(result.slug);
  const TaskPoints& task = found == points.end() ? TaskPoints{} : found->second;
  result.points = result.max_points = result.bonus_points = 0;
  for (PromiseResult& promise : result.promises) {
    promise.points = promise.name.starts_with(kExamples)
                         ? task.examples
                         : worth(task.promise, task.promises, promise.name);
    const int earned = is_kept_by_itself(promise) ? promise.points : 0;
    (promise.bonus ? result.bonus_points : result.points) += earned;
    if (!promise.bonus) result.max_points += promise.points;
  }
  result.spared = spared_by(task, result);
  result.points += result.spared;
  const double share = result.max_points > 0 ? 1.0 * result.points / result.max_points : 1;
  for (PictureResult& picture : result.pictures) {
    picture.max_points = worth(task.picture, task.pictures, picture.recipe);
    const int most = static_cast<int>(std::lround(share * picture.max_points));
    // A wrong picture is called integrated only if it is right with the reference for all other tasks.
    picture.points = picture.state == State::pass || picture.integrated ? most
                     : picture.state == State::too_noisy ? std::min(task.too_noisy, most)
                                                         : 0;
    result.points += picture.points;
    result.max_points += picture.max_points;
  }
  if (result.keeps_state) result.points = std::max(0, result.points - task.keeps_state);
}

}  // namespace grader::results
