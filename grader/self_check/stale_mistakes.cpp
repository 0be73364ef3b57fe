#include "grader/self_check/stale_mistakes.h"

#include "grader/base/sha256.h"
#include "grader/self_check/measure_mistakes.h"

#include <algorithm>

#include <fmt/format.h>

namespace grader::self_check {

namespace {

bool breaks_only_a_bonus(const Kept& kept) {
  return kept.text.substr(0, kept.text.find('\n')).ends_with("_bonus");
}

const mistakes::Fingerprint* find(const mistakes::KnownTask& task, const std::string& name) {
  const auto found = std::ranges::find(task.mistakes, name, &mistakes::Fingerprint::name);
  return found == task.mistakes.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::string> out_of_date(const judge::Config& config,
                                     const mistakes::KnownMistakes& known) {
  std::vector<std::string> reasons;
  for (const judge::TaskConfig& task : config.tasks) {
    const auto found = known.find(task.slug);
    if (found == known.end()) {
      reasons.push_back(task.slug + ": nothing is known");
      continue;
    }
    if (found->second.battery != battery_hash(config.root, task.slug)) {
      reasons.push_back(task.slug + ": its battery has changed");
    }
    const std::vector<Kept> kept = kept_solutions(config, task, {"wrong"});
    for (const Kept& each : kept) {
      const mistakes::Fingerprint* print = find(found->second, each.name);
      if (print == nullptr && !breaks_only_a_bonus(each)) {
        reasons.push_back(fmt::format("{}: {} is not known", task.slug, each.name));
      } else if (print != nullptr && print->source != base::sha256(each.text).substr(0, 16)) {
        reasons.push_back(fmt::format("{}: {} has changed", task.slug, each.name));
      }
    }
    for (const mistakes::Fingerprint& print : found->second.mistakes) {
      if (std::ranges::find(kept, print.name, &Kept::name) == kept.end()) {
        reasons.push_back(fmt::format("{}: {} is not kept any more", task.slug, print.name));
      }
    }
  }
  return reasons;
}

}  // namespace grader::self_check
