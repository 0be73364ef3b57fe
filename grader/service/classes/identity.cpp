#include "grader/service/classes/identity.h"

#include "grader/base/sha256.h"
#include "pt/error.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <random>
#include <utility>

#include <fmt/format.h>

namespace grader::classes {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDigitsOfAlias = 10;

bool has_plan(const std::string& folder) {
  return !folder.empty() && fs::exists(folder + "/plan.json");
}

// A namesake who hands in later changes a learner's name ("Ada (17)"), but not the ID.
std::string identity_of(const ClassPlan& plan, std::size_t i) {
  const intake::HandedIn& by = plan.everybody[i];
  if (!by.id.empty()) return fmt::format("{} {}", static_cast<int>(by.platform), by.id);
  return plan.real_names.empty() ? by.name : plan.real_names[i];
}

std::string alias_of(const std::string& salt, const std::string& identity) {
  return "submission-" + base::sha256(salt + identity).substr(0, kDigitsOfAlias);
}

std::string salt_for(const ClassPlan& plan, const std::string& out) {
  for (const std::string& folder : {out, plan.former}) {
    if (!has_plan(folder)) continue;
    const ClassPlan earlier = read_plan(folder);
    if (!earlier.salt.empty()) return earlier.salt;
    if (folder == out) {
      throw pt::Error(out + " has reports that show names; write --out another folder");
    }
  }
  return random_text();
}

}  // namespace

std::string random_text() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

void hide_names(ClassPlan& plan, const std::string& out) {
  plan.salt = salt_for(plan, out);
  std::vector<std::pair<std::string, intake::HandedIn>> all;
  for (std::size_t i = 0; i < plan.everybody.size(); ++i) {
    all.emplace_back(alias_of(plan.salt, identity_of(plan, i)), plan.everybody[i]);
  }
  // The order of names would reveal who is who.
  std::ranges::sort(all, {}, [](const auto& each) { return each.first; });
  for (std::size_t i = 0; i < all.size(); ++i) {
    intake::HandedIn& by = plan.everybody[i];
    by = all[i].second;
    plan.real_names.push_back(by.name);
    by.name = all[i].first;
    by.problem = without_names(by.problem, by.folder);
    by.note = without_names(by.note, by.folder);
  }
}

std::vector<std::string> former_names(const ClassPlan& plan) {
  std::vector<std::string> names;
  std::map<std::string, std::string> known;  // identity -> name
  if (has_plan(plan.former)) {
    const ClassPlan former = read_plan(plan.former);
    for (std::size_t i = 0; i < former.everybody.size(); ++i) {
      known[identity_of(former, i)] = former.everybody[i].name;
    }
  }
  for (std::size_t i = 0; i < plan.everybody.size(); ++i) {
    const auto found = known.find(identity_of(plan, i));
    names.push_back(found == known.end() ? "" : found->second);
  }
  return names;
}

std::vector<std::string> shown_former_names(const ClassPlan& plan, std::vector<std::string> names) {
  const bool hides = !plan.real_names.empty();
  const bool hidden = has_plan(plan.former) && !read_plan(plan.former).real_names.empty();
  if (!hides || hidden) return names;
  for (std::string& name : names) name = alias_of(plan.salt, name);
  return names;
}

std::string without_names(std::string sentence, const std::string& folder) {
  for (std::size_t at = 0; !folder.empty() && (at = sentence.find(folder, at)) != sentence.npos;) {
    sentence.replace(at, folder.size(), "…");
  }
  const std::size_t first = sentence.find('\''), last = sentence.rfind('\'');
  if (first != last) sentence.replace(first, last - first + 1, "'…'");
  return sentence;
}

}  // namespace grader::classes
