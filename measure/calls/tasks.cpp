#include "measure/calls/tasks.h"

#include "grader/tasks.h"
#include "pt/error.h"

#include <nlohmann/json.hpp>

namespace measure::calls {

namespace {

using nlohmann::json;

Kind kind_of(const std::string& word) {
  if (word == "exact") return Kind::exact;
  if (word == "estimator") return Kind::estimator;
  if (word == "tree") return Kind::tree;
  throw pt::Error("a task is measured as exact, estimator or tree, not as " + word);
}

std::vector<About> read_tasks() {
  std::vector<About> all;
  const json table = json::parse(grader::tasks_json);
  for (const json& task : table.at("tasks")) {
    const json& from = task.at("measured");
    all.push_back({.slug = task.at("slug"),
                   .kind = kind_of(from.at("kind")),
                   .cases = from.at("cases"),
                   .one_front = from.value("one_front", false),
                   .chooses_samples = from.value("chooses_samples", false),
                   .errors = from.at("errors"),
                   .inputs = from.at("inputs")});
  }
  return all;
}

}  // namespace

const std::vector<About>& tasks() {
  static const std::vector<About> all = read_tasks();
  return all;
}

}  // namespace measure::calls
