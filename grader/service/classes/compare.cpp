#include "grader/service/classes/compare.h"

#include "grader/results/json.h"
#include "grader/results/summary.h"
#include "grader/service/classes/identity.h"
#include "pt/error.h"

#include <filesystem>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace grader::classes {

namespace {

namespace fs = std::filesystem;

std::optional<results::Results> results_at(const std::string& path) {
  if (!fs::exists(path + ".key")) return std::nullopt;
  try {
    results::Results results = results::read_results(path + ".json");
    if (results.complete) return results;
  } catch (const pt::Error&) {
    // another judge wrote them
  }
  return std::nullopt;
}

}  // namespace

platforms::Comparison compare(const ClassPlan& plan, const std::string& former,
                              const std::string& out) {
  platforms::Comparison comparison;
  comparison.former = former;
  std::set<std::string> names(plan.former_names.begin(), plan.former_names.end());
  const fs::path old_reports = former, new_reports = out;
  for (std::size_t i = 0; i < plan.everybody.size(); ++i) {
    const intake::HandedIn& by = plan.everybody[i];
    const std::string& name = plan.former_names.at(i);
    const auto before = name.empty() ? std::nullopt : results_at(old_reports / name);
    const auto after = results_at(new_reports / by.name);
    if (before && after) {
      const results::Totals old = results::totals(before->tasks);
      const results::Totals now = results::totals(after->tasks);
      comparison.rows.push_back({by.name, by.name + ".html", old.points + old.bonus_points,
                                 old.max_points, now.points + now.bonus_points, now.max_points,
                                 results::changes(*before, *after)});
    } else if (before) {
      comparison.only_before.push_back(by.name);
    } else if (after) {
      comparison.only_after.push_back(by.name);
    }
  }
  std::vector<std::string> gone;
  for (const auto& entry : fs::directory_iterator(former)) {
    const std::string name = entry.path().stem();
    if (entry.path().extension() == ".key" && !names.contains(name)) {
      gone.push_back(name);
    }
  }
  for (const std::string& name : shown_former_names(plan, std::move(gone))) {
    comparison.only_before.push_back(name);
  }
  return comparison;
}

}  // namespace grader::classes
