#include "grader/results/changes.h"

#include "grader/results/points.h"

#include <algorithm>
#include <map>

namespace grader::results {

namespace {

// A promise, picture or rule of a task, and the points that it earned.
struct Item {
  std::string key, words;
  int points = 0;
};

std::vector<Item> items_of(const TaskResult& task) {
  std::vector<Item> items;
  int sum = 0;
  for (const PromiseResult& promise : task.promises) {
    const int earned = is_kept_by_itself(promise) ? promise.points : 0;
    items.push_back(
        {"promise " + promise.name, promise.words.empty() ? promise.name : promise.words, earned});
    sum += earned;
  }
  for (const PictureResult& picture : task.pictures) {
    items.push_back({"picture " + picture.recipe, "picture " + picture.recipe, picture.points});
    sum += picture.points;
  }
  items.push_back({"spared", "one cause costs no more than its share", task.spared});
  const int left = task.points + task.bonus_points - sum - task.spared;
  items.push_back({"state", "a variable keeps its value between calls", left});
  return items;
}

void add_changes(const std::string& slug, const std::vector<Item>& before,
                 const std::vector<Item>& after, std::vector<Change>& all) {
  std::map<std::string, int> earned;
  for (const Item& item : before) earned[item.key] = item.points;
  for (const Item& item : after) {
    const int was = earned[item.key];
    earned.erase(item.key);
    if (was != item.points) all.push_back({slug, item.words, was, item.points});
  }
  for (const Item& item : before) {
    const bool gone = earned.contains(item.key) && item.points != 0;
    if (gone) all.push_back({slug, item.words, item.points, 0});
  }
}

}  // namespace

std::vector<Change> changes(const Results& before, const Results& after) {
  std::vector<Change> all;
  const auto items = [](const Results& results, const std::string& slug) {
    const auto found = std::ranges::find(results.tasks, slug, &TaskResult::slug);
    return found == results.tasks.end() ? std::vector<Item>{} : items_of(*found);
  };
  for (const TaskResult& task : after.tasks) {
    add_changes(task.slug, items(before, task.slug), items_of(task), all);
  }
  for (const TaskResult& task : before.tasks) {
    if (std::ranges::count(after.tasks, task.slug, &TaskResult::slug) > 0) continue;
    add_changes(task.slug, items_of(task), {}, all);
  }
  return all;
}

}  // namespace grader::results
