#include "grader/self_check/naming_score.h"

#include "grader/mistakes/compare.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::self_check {

namespace {

std::vector<std::string> names_of(const std::vector<const mistakes::Fingerprint*>& found) {
  std::vector<std::string> names;
  for (const mistakes::Fingerprint* each : found) names.push_back(each->name);
  return names;
}

const mistakes::Fingerprint* find(const mistakes::KnownTask& known, const std::string& name) {
  for (const mistakes::Fingerprint& each : known.mistakes) {
    if (each.name == name) return &each;
  }
  return nullptr;
}

mistakes::KnownTask without(mistakes::KnownTask known, const std::string& name) {
  std::erase_if(known.mistakes,
                [&](const mistakes::Fingerprint& each) { return each.name == name; });
  return known;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void Score::add(const mistakes::KnownTask& known, const std::string& slug, const std::string& kind,
                const std::string& name, const mistakes::Evidence& evidence) {
  if (kind == "variation") return add_variation(known, name, evidence, slug);
  if (kind == "wrong") return add_wrong(known, name, evidence, slug);
  Counts& counts = tasks_[slug];
  ++counts.right;
  const bool as_right = mistakes::agree(evidence.answers, known.right);
  // Also if it failed: then it would have no name either.
  mistakes::Evidence failed = evidence;
  if (!evidence.kept.empty()) failed.broken.insert(*evidence.kept.begin());
  const auto found = mistakes::name_by_battery(known, failed);
  counts.right_named += found.empty() ? 0 : 1;
  if (!found.empty() || !as_right) {
    lines_.push_back(fmt::format("{} {} {}: {}named {}", slug, kind, name,
                                 as_right ? "" : "answers unlike the reference, ",
                                 fmt::join(names_of(found), ", ")));
  }
}

void Score::add_wrong(const mistakes::KnownTask& known, const std::string& name,
                      const mistakes::Evidence& evidence, const std::string& slug) {
  Counts& counts = tasks_[slug];
  const mistakes::Fingerprint* own = find(known, name);
  if (own == nullptr || evidence.broken.empty()) {
    ++counts.passing;
    if (own != nullptr) lines_.push_back(fmt::format("{} {}: passes", slug, name));
    return;
  }
  ++counts.wrong;
  const auto names = names_of(mistakes::name_by_battery(known, evidence));
  counts.named += contains(names, name) ? 1 : 0;
  counts.alone += names.size() == 1 && contains(names, name) ? 1 : 0;
  counts.misnamed += !names.empty() && !contains(names, name) ? 1 : 0;
  if (!contains(names, name)) {
    const bool unseen = mistakes::agree(evidence.answers, known.right);
    const bool explained = mistakes::explains(*own, evidence);
    counts.unseen += unseen ? 1 : 0;
    counts.ambiguous += !unseen && explained ? 1 : 0;
    std::vector<std::string> also;
    for (const mistakes::Fingerprint& each : known.mistakes) {
      if (mistakes::explains(each, evidence)) also.push_back(each.name);
    }
    lines_.push_back(fmt::format("{} {}: {}; explained by: {}; named: {}", slug, name,
                                 unseen      ? "unseen"
                                 : explained ? "ambiguous"
                                 : mistakes::agree(evidence.answers, own->answers)
                                     ? "other promises"
                                     : "other answers",
                                 fmt::join(also, ", "), fmt::join(names, ", ")));
  }
  // Without its own fingerprint it may only be called what shows in the same way.
  const mistakes::KnownTask others = without(known, name);
  for (const mistakes::Fingerprint* other : mistakes::name_by_battery(others, evidence)) {
    if (mistakes::agree(other->answers, own->answers)) continue;
    ++counts.left_out;
    lines_.push_back(fmt::format("{} {}: left out, it is named {}", slug, name, other->name));
    break;
  }
}

void Score::add_variation(const mistakes::KnownTask& known, const std::string& name,
                          const mistakes::Evidence& evidence, const std::string& slug) {
  Counts& counts = tasks_[slug];
  ++counts.varied;
  const auto names = names_of(mistakes::name_by_battery(known, evidence));
  counts.varied_named += contains(names, name) ? 1 : 0;
  counts.misnamed += !names.empty() && !contains(names, name) ? 1 : 0;
  if (contains(names, name)) return;
  const mistakes::Fingerprint* own = find(known, name);
  lines_.push_back(fmt::format("{} variation of {}: {}; named: {}", slug, name,
                               own == nullptr                                    ? "not known"
                               : mistakes::agree(evidence.answers, own->answers) ? "other promises"
                                                                                 : "other answers",
                               fmt::join(names, ", ")));
}

std::string Score::text(bool verbose) const {
  std::string text;
  if (verbose) {
    for (const std::string& line : lines_) text += line + "\n";
  }
  text += fmt::format("{:<18} {:>5} {:>6} {:>6} {:>9} {:>7} {:>10} {:>9} {:>9} {:>7}\n", "task",
                      "wrong", "named", "alone", "misnamed", "unseen", "ambiguous", "left out",
                      "right", "varied");
  Counts all;
  for (const auto& [slug, c] : tasks_) {
    text += fmt::format("{:<18} {:>5} {:>6} {:>6} {:>9} {:>7} {:>10} {:>9} {:>9} {:>7}\n", slug,
                        c.wrong, c.named, c.alone, c.misnamed, c.unseen, c.ambiguous, c.left_out,
                        fmt::format("{}/{}", c.right_named, c.right),
                        fmt::format("{}/{}", c.varied_named, c.varied));
    all.wrong += c.wrong;
    all.named += c.named;
    all.misnamed += c.misnamed;
    all.left_out += c.left_out;
    all.passing += c.passing;
  }
  return text + fmt::format(
                    "{} of {} wrong solutions are named right, {} wrong; {} more break only a "
                    "bonus. Left out, {} are named as another.\n",
                    all.named, all.wrong, all.misnamed, all.passing, all.left_out);
}

double Score::share_named() const {
  int named = 0, wrong = 0;
  for (const auto& [slug, counts] : tasks_) {
    named += counts.named;
    wrong += counts.wrong;
  }
  return wrong == 0 ? 1 : static_cast<double>(named) / wrong;
}

double Score::share_left_out() const {
  int left_out = 0, wrong = 0;
  for (const auto& [slug, counts] : tasks_) {
    left_out += counts.left_out;
    wrong += counts.wrong;
  }
  return wrong == 0 ? 0 : static_cast<double>(left_out) / wrong;
}

int Score::misnamed() const {
  int sum = 0;
  for (const auto& [slug, counts] : tasks_) sum += counts.misnamed + counts.right_named;
  return sum;
}

}  // namespace grader::self_check
