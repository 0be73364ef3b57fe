#include "grader/service/intake/names_that_differ.h"

#include "grader/service/intake/file_name.h"
#include "pt/printable.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

namespace grader::intake {

namespace {

// Names of files and folders for the class as a whole, in the folder of the reports.
const std::set<std::string>& reserved_names() {
  static const std::set<std::string> names{
      "class",  "plan",  "compare",  "names",    "canvas", "moodle",   "seed",
      "joblog", "slurm", "feedback", "likeness", "engine", "unpacked", "gradescope"};
  return names;
}

std::map<std::string, int> count_of_names(const std::vector<HandedIn>& all) {
  std::map<std::string, int> count;
  for (const HandedIn& each : all) ++count[folded(each.name)];
  return count;
}

}  // namespace

std::set<std::string> ids_of(const HandedIn& by) {
  std::set<std::string> ids;
  for (std::size_t at = 0, end = 0; at < by.id.size(); at = end + 2) {
    end = by.platform == Platform::gradescope ? by.id.find(", ", at) : by.id.npos;
    end = std::min(end, by.id.size());
    ids.insert(by.id.substr(at, end - at));
  }
  return ids;
}

std::vector<HandedIn> with_ids_that_differ(std::vector<HandedIn> all) {
  std::map<std::pair<Platform, std::string>, std::vector<HandedIn*>> owners;
  for (HandedIn& by : all) {
    for (const std::string& id : ids_of(by)) owners[{by.platform, id}].push_back(&by);
  }
  for (const auto& [key, rows] : owners) {
    for (HandedIn* by : rows) {
      if (rows.size() == 1) continue;
      by->problem = fmt::format(
          "its ID '{}' is also that of '{}', and nobody knows whose work is whose: correct the "
          "names of the files, or take one out",
          as_file_name(key.second), as_file_name(rows[by == rows[0] ? 1 : 0]->name));
      by->id.clear();
    }
  }
  return all;
}

std::vector<HandedIn> with_names_that_differ(std::vector<HandedIn> all) {
  for (HandedIn& each : all) each.name = as_file_name(each.name);
  // Twice: a name with an ID behind it may be what somebody else is called.
  std::set<HandedIn*> have_ids;
  for (int i = 0; i < 2; ++i) {
    const std::map<std::string, int> before = count_of_names(all);
    for (HandedIn& each : all) {
      if (before.at(folded(each.name)) > 1 && !each.id.empty() && have_ids.insert(&each).second)
        each.name += " (" + as_file_name(std::string(pt::beginning(each.id, 30))) + ")";
    }
  }
  // A number behind a name must not make it that of somebody else.
  const std::map<std::string, int> count = count_of_names(all);
  std::stable_partition(all.begin(), all.end(), [&](const HandedIn& each) {
    const std::string key = folded(each.name);
    return count.at(key) == 1 && !reserved_names().contains(key);
  });
  // A name with marks must also differ from names that have the marks in the letter.
  std::stable_partition(all.begin(), all.end(),
                        [](const HandedIn& each) { return !has_marks(each.name); });
  std::set<std::string> used = reserved_names(), plain;
  const auto is_new = [&](const std::string& name) {
    const std::string key = folded(name), without = accents_alike(key);
    if (has_marks(name)) return !plain.contains(without) && used.insert(key).second;
    plain.insert(without);
    return used.insert(key).second;
  };
  for (HandedIn& each : all) {
    std::string name = each.name;
    for (int i = 2; !is_new(name); ++i) name = fmt::format("{} ({})", each.name, i);
    each.name = name;
    if (each.platform == Platform::none) each.feedback = name + ".html";
  }
  std::sort(all.begin(), all.end(),
            [](const HandedIn& a, const HandedIn& b) { return a.name < b.name; });
  return all;
}

}  // namespace grader::intake
