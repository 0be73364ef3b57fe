#include "grader/service/judging/no_reference.h"

#include "grader/tasks.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::judging {

build::Config with_own_tasks(build::Config config, const std::vector<Judged>& judged) {
  for (build::TaskConfig& task : config.tasks) {
    for (const Judged& each : judged) {
      const bool own = each.config->slug == task.slug && each.object.ok();
      if (own) task.reference = {each.object.path};
    }
  }
  return config;
}

void block_by_own_tasks(std::vector<Judged>& judged) {
  for (Judged& each : judged) {
    results::TaskResult& result = each.result;
    each.settled = each.settled || !each.right_alone;
    const bool ran = each.object.ok() && result.compiler_output.empty();
    if (!ran || result.state == results::State::pass ||
        result.state == results::State::not_attempted)
      continue;
    std::vector<std::string> by;
    for (const Judged& other : judged) {
      const std::string& slug = other.config->slug;
      const std::vector<std::string>& needed = needs(result.slug);
      if (std::ranges::count(needed, slug) > 0 && !other.right_alone) by.push_back(slug);
    }
    if (by.empty()) continue;
    result.state = results::State::blocked;
    result.blocked_by = by;
    result.reason = fmt::format("without the reference it is judged when {} {}",
                                fmt::join(by, ", "), by.size() == 1 ? "passes" : "pass");
  }
}

std::vector<std::string> missing_for(const std::vector<std::string>& slugs,
                                     const std::vector<Judged>& judged) {
  std::vector<std::string> missing, before;
  for (const Judged& each : judged) {
    if (!each.right_alone) before.push_back(each.config->slug);
    if (std::ranges::count(slugs, each.config->slug) > 0) missing = before;
  }
  return missing;
}

}  // namespace grader::judging
